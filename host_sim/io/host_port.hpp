#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace host_sim {

/// A host and, where it is given, a port. The host is a view into the text.
struct HostPort {
  std::string_view host;  ///< not empty; an IPv6 number without its brackets
  std::optional<std::uint16_t> port;
};

/// "localhost", "127.0.0.1:8080", "[::1]", "[::1]:8080" (RFC 3986, 3.2); nothing where it is none.
[[nodiscard]] std::optional<HostPort> host_port_of(std::string_view text);

}  // namespace host_sim
