#include "host_sim/monitor/http/address.hpp"

#include <arpa/inet.h>

#include <charconv>
#include <optional>

#include "host_sim/io/input_error.hpp"

namespace host_sim::monitor {
namespace {

struct Parts {
  std::string_view host;
  std::string_view port;
};

/// Host and port; an IPv6 number stands in brackets.
std::optional<Parts> divide(std::string_view text) {
  if (text.starts_with('[')) {
    const std::size_t end = text.find("]:");
    if (end == std::string_view::npos) {
      return std::nullopt;
    }
    return Parts{text.substr(1, end - 1), text.substr(end + 2)};
  }
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || text.find(':', colon + 1) != std::string_view::npos) {
    return std::nullopt;
  }
  return Parts{text.substr(0, colon), text.substr(colon + 1)};
}

std::string_view host_of_header(std::string_view header) {
  if (header.starts_with('[')) {
    const std::size_t end = header.find(']');
    return end == std::string_view::npos ? std::string_view{} : header.substr(1, end - 1);
  }
  return header.substr(0, header.find(':'));
}

}  // namespace

std::string Address::text() const {
  const bool brackets = host.find(':') != std::string::npos;
  return (brackets ? '[' + host + ']' : host) + ':' + std::to_string(port);
}

Address parse_address(std::string_view text) {
  const std::optional<Parts> parts = divide(text);
  std::uint16_t port = 0;
  bool good = parts && !parts->host.empty() && !parts->port.empty();
  if (good) {
    const char* const end = parts->port.data() + parts->port.size();
    const auto [rest, error] = std::from_chars(parts->port.data(), end, port);
    good = error == std::errc{} && rest == end;
  }
  if (!good) {
    throw InputError("--http", 0, 0, "'" + std::string(text) + "'",
                     "ADDRESS:PORT, such as 127.0.0.1:8080 or [::1]:8080");
  }
  return {std::string(parts->host), port};
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
  return is_loopback(host_of_header(header));
}

}  // namespace host_sim::monitor
