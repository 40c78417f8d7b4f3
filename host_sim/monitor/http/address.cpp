#include "host_sim/monitor/http/address.hpp"

#include <arpa/inet.h>

#include <optional>

#include "host_sim/io/host_port.hpp"
#include "host_sim/io/input_error.hpp"

namespace host_sim::monitor {

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

}  // namespace host_sim::monitor
