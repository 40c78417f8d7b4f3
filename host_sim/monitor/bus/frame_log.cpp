#include "host_sim/monitor/bus/frame_log.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "hal/files/input_file.hpp"
#include "hal/files/text.hpp"
#include "host_sim/monitor/bus/asc_reader.hpp"
#include "host_sim/monitor/bus/can_packet.hpp"
#include "host_sim/monitor/bus/pcap_reader.hpp"

namespace host_sim::monitor {

using hal::files::candump_line;
using hal::files::in_quotes;
using hal::files::InputError;
using hal::files::LoggedFrame;
using hal::files::open_source;

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

LoggedFrame::Kind logged_kind(const SeenFrame& seen) {
  if (seen.error) {
    return LoggedFrame::Kind::kError;
  }
  if (seen.flexible_data_rate) {
    return LoggedFrame::Kind::kFd;
  }
  return seen.remote_request ? LoggedFrame::Kind::kRemote : LoggedFrame::Kind::kData;
}

constexpr std::string_view kAcceptedLog =
    "a log of candump -L, a Vector ASC file, or PCAP or PCAPNG of a CAN interface";

std::string front_of(const std::filesystem::path& path) {
  const auto source = open_source(path, kAcceptedLog);
  std::array<char, 512> buffer{};
  std::string front;
  while (front.size() < buffer.size()) {
    const std::size_t count = source->read(std::span(buffer).first(buffer.size() - front.size()));
    if (count == 0) {
      break;
    }
    front.append(buffer.data(), count);
  }
  return front;
}

std::string_view without_mark(std::string_view front) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  return front.starts_with(kByteOrderMark) ? front.substr(kByteOrderMark.size()) : front;
}

[[noreturn]] void refuse(const std::filesystem::path& path, std::string_view front) {
  const std::string_view line = front.substr(0, front.find_first_of("\r\n"));
  const bool other_candump =
      line.find('[') != std::string_view::npos && line.find(']') != std::string_view::npos;
  throw InputError(path.string(), 1, 1,
                   other_candump ? "output of candump in another format than that of -L"
                                 : in_quotes(line.substr(0, 40)),
                   kAcceptedLog);
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

std::string log_line(const SeenFrame& seen, std::string_view interface) {
  LoggedFrame logged;
  logged.time_us = static_cast<std::uint64_t>(seen.time_ns) / 1'000;
  logged.interface = interface;
  logged.kind = logged_kind(seen);
  logged.id = seen.frame.id;
  logged.extended = seen.frame.extended;
  logged.fd_flags = seen.fd_flags;
  const bool flexible = logged.kind == LoggedFrame::Kind::kFd;
  const std::span<const std::byte> data = flexible ? std::span(seen.fd_data) : seen.frame.data;
  std::copy_n(data.begin(), std::min(data.size(), logged.data.size()), logged.data.begin());
  logged.length = flexible ? static_cast<std::uint8_t>(seen.fd_data.size()) : seen.frame.length;
  return candump_line(logged);
}

std::unique_ptr<LogReader> open_log(const std::filesystem::path& path) {
  if (path == "-") {
    return std::make_unique<CandumpLogReader>(path);
  }
  const std::string bytes = front_of(path);
  const std::string_view front = without_mark(bytes);
  if (is_pcap(front)) {
    return std::make_unique<PcapReader>(path);
  }
  if (is_asc(front)) {
    return std::make_unique<AscReader>(open_source(path, kAcceptedLog), path.string());
  }
  if (front.empty() || front.starts_with('(') || front.starts_with('#')) {
    return std::make_unique<CandumpLogReader>(path);
  }
  refuse(path, front);
}

}  // namespace host_sim::monitor
