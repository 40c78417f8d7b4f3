#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "host_sim/monitor/http/address.hpp"

namespace host_sim::monitor {

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

  /// Cookies do not tell ports apart by themselves. Before the first ask().
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
