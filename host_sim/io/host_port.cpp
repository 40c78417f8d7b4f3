#include "host_sim/io/host_port.hpp"

#include <algorithm>
#include <charconv>

namespace host_sim {
namespace {

struct HostAndRest {
  std::string_view host;
  std::string_view rest;
};

std::optional<HostAndRest> divide(std::string_view text) {
  if (!text.starts_with('[')) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    return HostAndRest{text.substr(0, colon), text.substr(colon)};
  }
  const std::size_t end = text.find(']');
  if (end == std::string_view::npos) {
    return std::nullopt;
  }
  return HostAndRest{text.substr(1, end - 1), text.substr(end + 1)};
}

}  // namespace

std::optional<HostPort> host_port_of(std::string_view text) {
  const std::optional<HostAndRest> parts = divide(text);
  if (!parts || parts->host.empty()) {
    return std::nullopt;
  }
  if (parts->rest.empty()) {
    return HostPort{parts->host, std::nullopt};
  }
  const std::string_view digits = parts->rest.substr(1);
  const char* const end = digits.data() + digits.size();
  std::uint16_t port = 0;
  const auto [stop, error] = std::from_chars(digits.data(), end, port);
  if (parts->rest.front() != ':' || error != std::errc{} || stop != end) {
    return std::nullopt;
  }
  return HostPort{parts->host, port};
}

}  // namespace host_sim
