#include "host_sim/monitor/record/log_line.hpp"

#include <algorithm>
#include <span>

#include "host_sim/io/candump.hpp"

namespace host_sim::monitor {
namespace {

using Kind = LoggedFrame::Kind;

Kind kind_of(const SeenFrame& seen) {
  if (seen.error) {
    return Kind::kError;
  }
  if (seen.flexible_data_rate) {
    return Kind::kFd;
  }
  return seen.remote_request ? Kind::kRemote : Kind::kData;
}

}  // namespace

std::string log_line(const SeenFrame& seen, std::string_view interface) {
  LoggedFrame logged;
  logged.time_us = static_cast<std::uint64_t>(seen.time_ns) / 1'000;
  logged.interface = interface;
  logged.kind = kind_of(seen);
  logged.id = seen.frame.id;
  logged.extended = seen.frame.extended;
  logged.fd_flags = seen.fd_flags;
  const bool flexible = logged.kind == Kind::kFd;
  const std::span<const std::byte> data = flexible ? std::span(seen.fd_data) : seen.frame.data;
  std::copy_n(data.begin(), std::min(data.size(), logged.data.size()), logged.data.begin());
  logged.length = flexible ? static_cast<std::uint8_t>(seen.fd_data.size()) : seen.frame.length;
  return candump_line(logged);
}

}  // namespace host_sim::monitor
