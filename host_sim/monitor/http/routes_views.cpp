#include <atomic>
#include <memory>
#include <string>

#include "host_sim/monitor/http/event_stream.hpp"
#include "host_sim/monitor/http/json_text.hpp"
#include "host_sim/monitor/http/node_of_path.hpp"
#include "host_sim/monitor/http/routes.hpp"
#include "host_sim/monitor/http/view_json.hpp"

namespace host_sim::monitor::routes {
namespace {

constexpr int kUnavailable = 503;
constexpr const char* kJson = "application/json";
constexpr const char* kText = "text/plain; charset=utf-8";

/// Counts one reader for as long as it lives.
class Place {
 public:
  explicit Place(std::shared_ptr<std::atomic<std::size_t>> taken) : taken_(std::move(taken)) {
    number_ = ++*taken_;
  }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;
  ~Place() { --*taken_; }
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  std::shared_ptr<std::atomic<std::size_t>> taken_;
  std::size_t number_ = 0;
};

struct Reader {
  Reader(std::shared_ptr<std::atomic<std::size_t>> taken, Hub& hub)
      : place(std::move(taken)), stream(hub) {}
  Place place;
  EventStream stream;
};

}  // namespace

void events(httplib::Server& server, Hub& hub, std::size_t most_readers) {
  auto taken = std::make_shared<std::atomic<std::size_t>>(0);
  server.Get("/events",
             [&hub, taken, most_readers](const httplib::Request&, httplib::Response& response) {
               auto reader = std::make_shared<Reader>(taken, hub);
               if (reader->place.number() > most_readers) {
                 response.status = kUnavailable;
                 response.set_header("Retry-After", "5");
                 response.set_content("Too many pages are open.\n", kText);
                 return;
               }
               response.set_chunked_content_provider(
                   "text/event-stream", [reader](std::size_t, httplib::DataSink& sink) {
                     const std::string piece = reader->stream.next();
                     return !piece.empty() && sink.write(piece.data(), piece.size());
                   });
             });
}

void views(httplib::Server& server, const Hub& hub) {
  server.Get("/api/fleet", [&hub](const httplib::Request&, httplib::Response& response) {
    const auto view = hub.view();
    if (!view) {
      response.status = kUnavailable;
      return;
    }
    response.set_content(json_text(fleet_json(*view)), kJson);
  });
  server.Get("/api/node/([0-9]{1,3})",
             [&hub](const httplib::Request& request, httplib::Response& response) {
               const auto view = hub.view();
               const NodeView* const node = node_of_path(view.get(), request.matches[1]);
               if (node == nullptr) {
                 response.status = 404;
                 return;
               }
               nlohmann::json json = node_json(*node);
               json.update(history_json(*node));
               response.set_content(json_text(json), kJson);
             });
  server.Get("/healthz", [&hub](const httplib::Request&, httplib::Response& response) {
    constexpr std::chrono::seconds kOld{5};
    const bool good = hub.view() && hub.age() < kOld;
    response.status = good ? 200 : kUnavailable;
    response.set_content(good ? "ok\n" : "the monitor gives no views\n", kText);
  });
}

}  // namespace host_sim::monitor::routes
