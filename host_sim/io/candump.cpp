#include "host_sim/io/candump.hpp"

#include <algorithm>
#include <utility>

namespace host_sim {
namespace {

constexpr std::string_view kAcceptedLog = "a log of candump -L, or - for standard input";

}  // namespace

std::optional<hal::CanFrame> LoggedFrame::classic() const {
  if (kind != Kind::kData) {
    return std::nullopt;
  }
  hal::CanFrame frame{.id = id, .extended = extended, .length = length};
  std::copy_n(data.begin(), frame.data.size(), frame.data.begin());
  return frame;
}

CandumpReader::CandumpReader(const std::filesystem::path& path)
    : CandumpReader(open_source(path, kAcceptedLog),
                    path == "-" ? "standard input" : path.string()) {}

CandumpReader::CandumpReader(std::unique_ptr<ByteSource> source, std::string_view name)
    : name_(name), lines_(std::move(source), name_) {}

std::optional<LoggedFrame> CandumpReader::next() {
  while (lines_.fill()) {
    const bool comment = *lines_.position() == '#';
    std::optional<LoggedFrame> frame;
    if (!comment) {
      frame = parse_candump_line({name_, lines_.line_number(), lines_.line()});
    }
    lines_.next_line(lines_.line_end());
    if (frame) {
      return frame;
    }
  }
  return std::nullopt;
}

}  // namespace host_sim
