#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace host_sim::monitor {

/// Where the live page listens.
struct Address {
  std::string host;        ///< a name or a number, IPv6 without brackets
  std::uint16_t port = 0;  ///< 0: any that is free

  /// As it stands in a URL: "127.0.0.1:8080", "[::1]:8080".
  [[nodiscard]] std::string text() const;
};

/// "127.0.0.1:8080", "[::1]:8080", "localhost:0".
/// @throws InputError
Address parse_address(std::string_view text);

/// Whether only this machine can reach it: 127.0.0.0/8, ::1, localhost.
bool is_loopback(std::string_view host);

/// Whether the Host header of a request is that of a page on loopback: a page of another site that
/// had its name resolved to 127.0.0.1 sends its own name.
bool is_loopback_header(std::string_view header);

}  // namespace host_sim::monitor
