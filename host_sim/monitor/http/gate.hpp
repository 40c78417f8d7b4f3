#pragma once

#include <cstdint>
#include <optional>
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

/// Takes the same time wherever the texts differ first.
bool equal_in_constant_time(std::string_view one, std::string_view other);

/// The value of a cookie in a Cookie header; empty without it.
std::string_view cookie_of(std::string_view header, std::string_view name);

/// A token is 16 to 256 letters, digits and `-._~+/=`, so that it may stand in a header and cookie.
/// @throws InputError
void check_token(std::string_view token);

/// What a request brings to be let in.
struct Credentials {
  std::string host = {};           ///< header
  std::string authorization = {};  ///< header
  std::string cookie = {};         ///< header
  std::string query_token = {};
};

/// Who may see the page: on loopback whoever names it as such, with a token whoever has it.
class Gate {
 public:
  enum class Answer : std::uint8_t {
    open,
    open_by_query,  ///< give the cookie, so that the token can leave the address line
    wrong_host,
    no_token,
  };

  /// @throws InputError for an address that others can reach without a token, and for a bad token
  Gate(const Address& address, std::optional<std::string> token);

  [[nodiscard]] Answer ask(const Credentials& credentials) const;

  /// Cookies do not distinguish ports by themselves. Before the first ask().
  void listens_at(std::uint16_t port) { port_ = port; }
  /// The Set-Cookie header.
  [[nodiscard]] std::string set_cookie() const;

 private:
  [[nodiscard]] bool is_token(std::string_view text) const;
  [[nodiscard]] std::string cookie_name() const;

  std::optional<std::string> token_;
  std::uint16_t port_ = 0;
};

}  // namespace host_sim::monitor
