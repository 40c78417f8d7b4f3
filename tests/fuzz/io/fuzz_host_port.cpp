// Whatever the bytes: nothing, or a host and a port that say the same as the text.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "host_sim/io/host_port.hpp"
#include "tests/fuzz/io/require.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto found = host_sim::host_port_of(text);
  if (!found) {
    return 0;
  }
  using host_sim::fuzz::require;
  require(!found->host.empty());
  const std::string bracketed = '[' + std::string(found->host) + ']';
  std::string again = text.front() == '[' ? bracketed : std::string(found->host);
  if (found->port) {
    again += ':';
    const std::string_view digits = text.substr(again.size());
    require(std::stoul(std::string(digits)) == *found->port);
    again += digits;
  }
  require(again == text);
  return 0;
}
