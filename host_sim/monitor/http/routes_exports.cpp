#include <string>

#include "host_sim/monitor/http/history_csv.hpp"
#include "host_sim/monitor/http/node_of_path.hpp"
#include "host_sim/monitor/http/routes.hpp"

namespace host_sim::monitor::routes {
namespace {

constexpr int kNotFound = 404;

void name_file(httplib::Response& response, const std::string& name) {
  response.set_header("Content-Disposition", "attachment; filename=\"" + name + "\"");
}

void say(httplib::Response& response, const char* why) {
  response.status = kNotFound;
  response.set_content(why, "text/plain; charset=utf-8");
}

void send_log(httplib::Response& response, const FrameArchive* archive,
              std::optional<protocol::Node> node, const std::string& name) {
  if (archive == nullptr) {
    say(response, "No frames are recorded: start the monitor with a folder to record to.\n");
    return;
  }
  name_file(response, name);
  response.set_chunked_content_provider(
      "text/plain; charset=utf-8", [archive, node](std::size_t, httplib::DataSink& sink) {
        bool taken = true;
        archive->read(node, [&](std::string_view piece) {
          taken = piece.empty() || sink.write(piece.data(), piece.size());
          return taken;
        });
        sink.done();
        return taken;
      });
}

}  // namespace

void exports(httplib::Server& server, const Hub& hub, const FrameArchive* archive) {
  server.Get("/export/([0-9]{1,3})\\.csv",
             [&hub](const httplib::Request& request, httplib::Response& response) {
               const auto view = hub.view();
               const NodeView* const node = node_of_path(view.get(), request.matches[1]);
               if (node == nullptr) {
                 say(response, "There is no such node.\n");
                 return;
               }
               name_file(response, "node-" + std::to_string(node->node) + ".csv");
               response.set_content(history_csv(*node), "text/csv; charset=utf-8");
             });
  server.Get("/export/([0-9]{1,3})\\.candump", [&hub, archive](const httplib::Request& request,
                                                               httplib::Response& response) {
    const auto view = hub.view();
    const NodeView* const node = node_of_path(view.get(), request.matches[1]);
    if (node == nullptr) {
      say(response, "There is no such node.\n");
      return;
    }
    send_log(response, archive, node->node, "node-" + std::to_string(node->node) + ".log");
  });
  server.Get("/export/all\\.candump",
             [archive](const httplib::Request&, httplib::Response& response) {
               send_log(response, archive, std::nullopt, "fleet.log");
             });
}

}  // namespace host_sim::monitor::routes
