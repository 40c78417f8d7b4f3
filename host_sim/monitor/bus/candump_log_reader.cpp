#include "host_sim/monitor/bus/candump_log_reader.hpp"

#include <algorithm>

#include "host_sim/io/input_error.hpp"
#include "host_sim/monitor/bus/error_frame.hpp"

namespace host_sim::monitor {
namespace {

constexpr std::uint64_t kLatest_us = 9'000'000'000'000'000;  // has room in nanoseconds

SeenFrame seen_of(const LoggedFrame& logged) {
  SeenFrame seen;
  seen.time_ns = static_cast<std::int64_t>(logged.time_us) * 1'000;
  seen.frame.id = logged.id;
  seen.frame.extended = logged.extended;
  if (logged.kind == LoggedFrame::Kind::kFd) {
    seen.flexible_data_rate = true;
    seen.fd_flags = logged.fd_flags;
    seen.fd_data.assign(logged.payload().begin(), logged.payload().end());
    return seen;
  }
  seen.frame.length = logged.length;
  std::copy_n(logged.data.begin(), seen.frame.data.size(), seen.frame.data.begin());
  seen.remote_request = logged.kind == LoggedFrame::Kind::kRemote;
  if (logged.kind == LoggedFrame::Kind::kError) {
    seen.error = bus_error_of(seen.frame);
  }
  return seen;
}

}  // namespace

std::optional<SeenFrame> CandumpLogReader::next() {
  const auto logged = reader_.next();
  if (!logged) {
    return std::nullopt;
  }
  if (logged->time_us > kLatest_us) {
    throw InputError(name_, 0, 0, "a time of " + std::to_string(logged->time_us / 1'000'000) + " s",
                     "times up to 9000000000 s");
  }
  return seen_of(*logged);
}

}  // namespace host_sim::monitor
