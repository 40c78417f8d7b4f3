#include "host_sim/monitor/http/gate.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "hal/files/input_error.hpp"
#include "host_sim/io/host_port.hpp"

namespace host_sim::monitor {

using hal::files::InputError;

namespace {

bool is_token_character(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
         std::string_view("-._~+/=").find(c) != std::string_view::npos;
}

}  // namespace

std::string Address::text() const {
  const bool brackets = host.find(':') != std::string::npos;
  return (brackets ? '[' + host + ']' : host) + ':' + std::to_string(port);
}

Address parse_address(std::string_view text) {
  const std::optional<HostPort> found = host_port_of(text);
  if (!found || !found->port) {
    throw InputError("--http", 0, 0, "'" + std::string(text) + "'",
                     "ADDRESS:PORT, such as 127.0.0.1:8080 or [::1]:8080");
  }
  return {std::string(found->host), *found->port};
}

bool is_loopback(std::string_view host) {
  const std::string text(host);
  in_addr four{};
  if (inet_pton(AF_INET, text.c_str(), &four) == 1) {
    return (ntohl(four.s_addr) >> 24) == 127;
  }
  in6_addr six{};
  if (inet_pton(AF_INET6, text.c_str(), &six) == 1) {
    return IN6_IS_ADDR_LOOPBACK(&six);
  }
  return host == "localhost";
}

bool is_loopback_header(std::string_view header) {
  const std::optional<HostPort> found = host_port_of(header);
  return found && is_loopback(found->host);
}

bool equal_in_constant_time(std::string_view one, std::string_view other) {
  unsigned different = one.size() == other.size() ? 0 : 1;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const char twin = other.empty() ? '\0' : other[i % other.size()];
    different |= static_cast<unsigned char>(one[i] ^ twin);
  }
  return different == 0;
}

std::string_view cookie_of(std::string_view header, std::string_view name) {
  while (!header.empty()) {
    const std::size_t end = std::min(header.find(';'), header.size());
    std::string_view pair = header.substr(0, end);
    header.remove_prefix(std::min(end + 1, header.size()));
    pair.remove_prefix(std::min(pair.find_first_not_of(' '), pair.size()));
    if (pair.starts_with(name) && pair.substr(name.size()).starts_with('=')) {
      return pair.substr(name.size() + 1);
    }
  }
  return {};
}

void check_token(std::string_view token) {
  constexpr std::size_t kShortest = 16;
  constexpr std::size_t kLongest = 256;
  if (token.size() < kShortest || token.size() > kLongest ||
      !std::all_of(token.begin(), token.end(), is_token_character)) {
    throw InputError("--http-token", 0, 0, "a token that cannot be used",
                     "16 to 256 letters, digits and -._~+/=");
  }
}

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
