#include <string>

#include "host_sim/monitor/http/page_files.hpp"
#include "host_sim/monitor/http/routes.hpp"

namespace host_sim::monitor::routes {
namespace {

constexpr int kSeeOther = 303;
constexpr int kUnauthorized = 401;
constexpr int kForbidden = 403;

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
  response.set_content(why, "text/plain; charset=utf-8");
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
      refuse(response, 404, "There is no such file.\n");
      return;
    }
    response.set_content(file->text.data(), file->text.size(), std::string(file->type));
  };
  server.Get("/", answer);
  server.Get("/assets/[a-z0-9_.-]+", answer);
}

}  // namespace host_sim::monitor::routes
