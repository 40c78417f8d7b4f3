#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "host_sim/io/byte_source.hpp"
#include "host_sim/io/input_error.hpp"
#include "host_sim/io/printable.hpp"
#include "host_sim/monitor/bus/asc_reader.hpp"
#include "host_sim/monitor/bus/candump_log_reader.hpp"
#include "host_sim/monitor/bus/log_reader.hpp"
#include "host_sim/monitor/bus/pcap_reader.hpp"

namespace host_sim::monitor {
namespace {

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
