#include "host_sim/monitor/http/gate.hpp"

#include <utility>

#include "host_sim/io/input_error.hpp"
#include "host_sim/monitor/http/token.hpp"

namespace host_sim::monitor {

Gate::Gate(const Address& address, std::optional<std::string> token)
    : token_(std::move(token)), port_(address.port) {
  if (token_) {
    check_token(*token_);
  } else if (!is_loopback(address.host)) {
    throw InputError("--http", 0, 0,
                     "'" + address.text() + "', which others can reach, without --http-token",
                     "127.0.0.1, [::1] or localhost, or any address with --http-token TOKEN");
  }
}

Gate::Answer Gate::ask(const Credentials& credentials) const {
  if (!token_) {
    return is_loopback_header(credentials.host) ? Answer::open : Answer::wrong_host;
  }
  constexpr std::string_view kBearer = "Bearer ";
  const std::string_view header = credentials.authorization;
  if (header.starts_with(kBearer) && is_token(header.substr(kBearer.size()))) {
    return Answer::open;
  }
  if (is_token(cookie_of(credentials.cookie, cookie_name()))) {
    return Answer::open;
  }
  return is_token(credentials.query_token) ? Answer::open_by_query : Answer::no_token;
}

std::string Gate::set_cookie() const {
  return cookie_name() + '=' + token_.value_or("") + "; Path=/; HttpOnly; SameSite=Lax";
}

std::string Gate::cookie_name() const {
  return "tendonlife_" + std::to_string(port_);
}

bool Gate::is_token(std::string_view text) const {
  return equal_in_constant_time(text, *token_);
}

}  // namespace host_sim::monitor
