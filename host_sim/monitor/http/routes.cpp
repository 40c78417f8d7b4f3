#include "host_sim/monitor/http/routes.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "host_sim/monitor/fleet/node_view.hpp"
#include "host_sim/monitor/http/view_json.hpp"
#include "host_sim/monitor/record/moment.hpp"
#include "host_sim/report/page/assets.hpp"

/// Files of the live page, embedded when the program is built.
namespace host_sim::monitor::assets {

// NOLINTBEGIN(readability-identifier-naming): named after the files
extern const std::string_view index_html;
extern const std::string_view live_css;
extern const std::string_view address_js;
extern const std::string_view curves_js;
extern const std::string_view dom_js;
extern const std::string_view events_js;
extern const std::string_view fleet_js;
extern const std::string_view history_js;
extern const std::string_view main_js;
extern const std::string_view moments_js;
extern const std::string_view node_js;
extern const std::string_view prose_js;
extern const std::string_view stream_js;
extern const std::string_view tendons_js;
extern const std::string_view trust_js;
// NOLINTEND(readability-identifier-naming)

}  // namespace host_sim::monitor::assets

namespace host_sim::monitor::routes {

using nlohmann::json;

namespace {

constexpr int kSeeOther = 303;
constexpr int kUnauthorized = 401;
constexpr int kForbidden = 403;
constexpr int kNotFound = 404;
constexpr int kUnreadable = 500;
constexpr int kUnavailable = 503;

constexpr const char* kJson = "application/json";
constexpr const char* kText = "text/plain; charset=utf-8";

struct PageFile {
  std::string_view name;  ///< "/", "/assets/live.css", ..
  std::string_view type;
  std::string_view text;
};

/// A file of the page, or null.
const PageFile* find_page_file(std::string_view name) {
  constexpr std::string_view kHtml = "text/html; charset=utf-8";
  constexpr std::string_view kStyle = "text/css; charset=utf-8";
  constexpr std::string_view kScript = "text/javascript; charset=utf-8";
  namespace report = host_sim::assets;
  static const std::array files = {
      PageFile{"/", kHtml, assets::index_html},
      PageFile{"/assets/page.css", kStyle, report::page_css},
      PageFile{"/assets/live.css", kStyle, assets::live_css},
      PageFile{"/assets/uplot.css", kStyle, report::uplot_css},
      PageFile{"/assets/uplot.js", kScript, report::uplot_js},
      PageFile{"/assets/uplot.licence", kText, report::uplot_licence},
      PageFile{"/assets/guard.js", kScript, report::guard_js},
      PageFile{"/assets/charts.js", kScript, report::charts_js},
      PageFile{"/assets/address.js", kScript, assets::address_js},
      PageFile{"/assets/curves.js", kScript, assets::curves_js},
      PageFile{"/assets/dom.js", kScript, assets::dom_js},
      PageFile{"/assets/events.js", kScript, assets::events_js},
      PageFile{"/assets/fleet.js", kScript, assets::fleet_js},
      PageFile{"/assets/history.js", kScript, assets::history_js},
      PageFile{"/assets/main.js", kScript, assets::main_js},
      PageFile{"/assets/moments.js", kScript, assets::moments_js},
      PageFile{"/assets/node.js", kScript, assets::node_js},
      PageFile{"/assets/prose.js", kScript, assets::prose_js},
      PageFile{"/assets/stream.js", kScript, assets::stream_js},
      PageFile{"/assets/tendons.js", kScript, assets::tendons_js},
      PageFile{"/assets/trust.js", kScript, assets::trust_js},
  };
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&](const PageFile& file) { return file.name == name; });
  return found == files.end() ? nullptr : &*found;
}

constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; "
    "img-src 'self' data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

Credentials credentials_of(const httplib::Request& request) {
  return {.host = request.get_header_value("Host"),
          .authorization = request.get_header_value("Authorization"),
          .cookie = request.get_header_value("Cookie"),
          .query_token = request.get_param_value("token")};
}

void refuse(httplib::Response& response, int status, const char* why) {
  response.status = status;
  response.set_content(why, kText);
}

/// Whether the page of another site asks for it (Fetch Metadata). It could not read the answer, but
/// hold the places of others.
bool is_of_another_site(const httplib::Request& request) {
  return request.get_header_value("Sec-Fetch-Site") == "cross-site" &&
         request.get_header_value("Sec-Fetch-Mode") != "navigate";
}

bool is_handled(const Gate& gate, const httplib::Request& request, httplib::Response& response) {
  if (is_of_another_site(request)) {
    refuse(response, kForbidden, "This page answers to itself alone.\n");
    return true;
  }
  switch (gate.ask(credentials_of(request))) {
    case Gate::Answer::open:
      return false;
    case Gate::Answer::open_by_query:
      response.set_header("Set-Cookie", gate.set_cookie());
      if (request.path == "/") {
        response.set_redirect("/", kSeeOther);
        return true;
      }
      return false;
    case Gate::Answer::wrong_host:
      refuse(response, kForbidden, "This page answers to 127.0.0.1, [::1] and localhost alone.\n");
      return true;
    case Gate::Answer::no_token:
      response.set_header("WWW-Authenticate", "Bearer");
      refuse(response, kUnauthorized,
             "This page needs its token: open /?token=TOKEN once, or send the header "
             "Authorization: Bearer TOKEN.\n");
      return true;
  }
  return true;
}

/// The node of this number, of 1 to 3 digits; null where there is none, or no view yet.
const NodeView* node_of_path(const FleetView* view, const std::string& number) {
  constexpr int kHighest = 127;
  const int value = std::stoi(number);
  if (view == nullptr || value > kHighest) {
    return nullptr;
  }
  const auto found = view->nodes.find(static_cast<protocol::Node>(value));
  return found == view->nodes.end() ? nullptr : &found->second;
}

/// Counts one reader for as long as it lives.
class ReaderCount {
 public:
  explicit ReaderCount(std::shared_ptr<std::atomic<std::size_t>> taken) : taken_(std::move(taken)) {
    number_ = ++*taken_;
  }
  ReaderCount(const ReaderCount&) = delete;
  ReaderCount& operator=(const ReaderCount&) = delete;
  ~ReaderCount() { --*taken_; }
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  std::shared_ptr<std::atomic<std::size_t>> taken_;
  std::size_t number_ = 0;
};

struct Reader {
  Reader(std::shared_ptr<std::atomic<std::size_t>> taken, Hub& hub)
      : count(std::move(taken)), stream(hub) {}
  ReaderCount count;
  EventStream stream;
};

void name_file(httplib::Response& response, const std::string& name) {
  response.set_header("Content-Disposition", "attachment; filename=\"" + name + "\"");
}

void send_log(httplib::Response& response, const FrameArchive& archive,
              std::optional<protocol::Node> node, const std::string& name) {
  name_file(response, name);
  response.set_chunked_content_provider(
      kText, [&archive, node](std::size_t, httplib::DataSink& sink) {
        bool taken = true;
        archive.read(node, [&](std::string_view piece) {
          taken = piece.empty() || sink.write(piece.data(), piece.size());
          return taken;
        });
        sink.done();
        return taken;
      });
}

/// `matches`: its time and, where its history is asked for, a node.
void send_moment(httplib::Response& response, const FrameArchive& archive, const FleetView& now,
                 const httplib::Match& matches) {
  try {
    const std::int64_t time_us = std::min<std::int64_t>(std::stoll(matches[1]), kLatestMoment_us);
    const Moment moment = moment_of(archive, now, time_us);
    json answer = moment_json(moment, now);
    if (matches[2].matched) {
      if (const NodeView* const node = node_of_path(&moment.view, matches[2])) {
        answer["history"] = history_json(*node);
      }
    }
    response.set_content(json_text(answer), kJson);
  } catch (const hal::files::InputError& error) {
    refuse(response, kUnreadable, error.what());
  }
}

}  // namespace

void guard(httplib::Server& server, const Gate& gate) {
  server.set_default_headers({{"Content-Security-Policy", kPolicy},
                              {"X-Content-Type-Options", "nosniff"},
                              {"Referrer-Policy", "no-referrer"},
                              {"Cross-Origin-Resource-Policy", "same-origin"},
                              {"Cache-Control", "no-store"}});
  server.set_pre_routing_handler(
      [&gate](const httplib::Request& request, httplib::Response& response) {
        const bool handled = request.path != "/healthz" && is_handled(gate, request, response);
        return handled ? httplib::Server::HandlerResponse::Handled
                       : httplib::Server::HandlerResponse::Unhandled;
      });
}

void files(httplib::Server& server) {
  const auto answer = [](const httplib::Request& request, httplib::Response& response) {
    const PageFile* const file = find_page_file(request.path);
    if (file == nullptr) {
      refuse(response, kNotFound, "There is no such file.\n");
      return;
    }
    response.set_content(file->text.data(), file->text.size(), std::string(file->type));
  };
  server.Get("/", answer);
  server.Get("/assets/[a-z0-9_.-]+", answer);
}

void events(httplib::Server& server, Hub& hub, std::size_t most_readers) {
  auto taken = std::make_shared<std::atomic<std::size_t>>(0);
  server.Get("/events",
             [&hub, taken, most_readers](const httplib::Request&, httplib::Response& response) {
               auto reader = std::make_shared<Reader>(taken, hub);
               if (reader->count.number() > most_readers) {
                 response.set_header("Retry-After", "5");
                 refuse(response, kUnavailable, "Too many pages are open.\n");
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
                 response.status = kNotFound;
                 return;
               }
               json answer = node_json(*node);
               answer.update(history_json(*node));
               response.set_content(json_text(answer), kJson);
             });
  server.Get("/healthz", [&hub](const httplib::Request&, httplib::Response& response) {
    constexpr std::chrono::seconds kOld{5};
    const bool good = hub.view() && hub.age() < kOld;
    response.status = good ? 200 : kUnavailable;
    response.set_content(good ? "ok\n" : "the monitor gives no views\n", kText);
  });
}

void past(httplib::Server& server, const Hub& hub, const FrameArchive& archive) {
  server.Get("/api/times", [&](const httplib::Request&, httplib::Response& response) {
    const auto view = hub.view();
    if (!view) {
      response.status = kUnavailable;
      return;
    }
    response.set_content(json_text(times_json(archive.times_us(), archive.why_gone(), *view)),
                         kJson);
  });
  const auto one_at_a_time = std::make_shared<std::mutex>();
  server.Get("/api/moment/([0-9]{1,16})(?:/([0-9]{1,3}))?",
             [&, one_at_a_time](const httplib::Request& request, httplib::Response& response) {
               const auto now = hub.view();
               if (!now) {
                 response.status = kUnavailable;
                 return;
               }
               const std::lock_guard lock(*one_at_a_time);
               send_moment(response, archive, *now, request.matches);
             });
}

void exports(httplib::Server& server, const Hub& hub, const FrameArchive& archive) {
  server.Get("/export/([0-9]{1,3})\\.csv",
             [&hub](const httplib::Request& request, httplib::Response& response) {
               const auto view = hub.view();
               const NodeView* const node = node_of_path(view.get(), request.matches[1]);
               if (node == nullptr) {
                 refuse(response, kNotFound, "There is no such node.\n");
                 return;
               }
               name_file(response, "node-" + std::to_string(node->node) + ".csv");
               response.set_content(history_csv(*node), "text/csv; charset=utf-8");
             });
  server.Get("/export/([0-9]{1,3})\\.candump", [&hub, &archive](const httplib::Request& request,
                                                                httplib::Response& response) {
    const auto view = hub.view();
    const NodeView* const node = node_of_path(view.get(), request.matches[1]);
    if (node == nullptr) {
      refuse(response, kNotFound, "There is no such node.\n");
      return;
    }
    send_log(response, archive, node->node, "node-" + std::to_string(node->node) + ".log");
  });
  server.Get("/export/all\\.candump",
             [&archive](const httplib::Request&, httplib::Response& response) {
               send_log(response, archive, std::nullopt, "fleet.log");
             });
}

}  // namespace host_sim::monitor::routes
