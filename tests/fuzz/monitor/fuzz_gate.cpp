// Whatever a request brings, four lines of it: host, authorization, cookie, token of the address.
// With a token the gate opens to what has it in it; without one to what names this machine.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "host_sim/monitor/http/gate.hpp"
#include "tests/fuzz/io/require.hpp"

namespace {

using host_sim::fuzz::require;
using host_sim::monitor::Credentials;
using host_sim::monitor::Gate;

constexpr std::string_view kToken = "0123456789abcdef";

Credentials credentials_of(std::string_view text) {
  std::array<std::string, 4> lines;
  for (std::string& line : lines) {
    line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return {.host = lines[0], .authorization = lines[1], .cookie = lines[2], .query_token = lines[3]};
}

bool is_open(Gate::Answer answer) {
  return answer == Gate::Answer::open || answer == Gate::Answer::open_by_query;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Gate locked({"0.0.0.0", 8080}, std::string(kToken));
  static const Gate local({"127.0.0.1", 8080}, std::nullopt);
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Credentials credentials = credentials_of(text);
  if (is_open(locked.ask(credentials))) {
    require(credentials.query_token == kToken || credentials.authorization.ends_with(kToken) ||
            credentials.cookie.find("tendonlife_8080=" + std::string(kToken)) != std::string::npos);
  }
  if (is_open(local.ask(credentials))) {
    const std::string& host = credentials.host;
    require(host.starts_with("127.") || host.starts_with("localhost") || host.starts_with('['));
  }
  return 0;
}
