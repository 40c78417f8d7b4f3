#include "host_sim/monitor/http/recorded_folder.hpp"

#include <charconv>
#include <fstream>
#include <string>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/isotp/address.hpp"
#include "firmware/protocol/schema/plan.hpp"
#include "host_sim/monitor/record/log_folder.hpp"

namespace host_sim::monitor {
namespace {

std::optional<protocol::Node> node_of_plan(const hal::CanFrame& frame) {
  for (const protocol::schema::Frame* kind : protocol::schema::kFrames) {
    if (const auto node = protocol::node_of(*kind, frame)) {
      return node;
    }
  }
  return std::nullopt;
}

std::optional<protocol::Node> node_of_diagnosis(const hal::CanFrame& frame) {
  const auto address = protocol::isotp::Address::of(frame);
  if (!address) {
    return std::nullopt;
  }
  return address->source == protocol::isotp::kTester ? address->target : address->source;
}

/// Hands the lines of `node` in a piece of whole lines to `take`, in pieces of their own.
bool take_lines(std::string_view lines, std::optional<protocol::Node> node,
                const std::function<bool(std::string_view)>& take) {
  if (!node) {
    return take(lines);
  }
  std::string of_node;
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n') + 1);
    if (node_of_line(line) == node) {
      of_node += line;
    }
    lines.remove_prefix(line.size());
  }
  return of_node.empty() || take(of_node);
}

bool read_log(const std::filesystem::path& path, std::optional<protocol::Node> node,
              const std::function<bool(std::string_view)>& take) {
  constexpr std::size_t kPiece = std::size_t{256} << 10;
  std::ifstream log(path, std::ios::binary);
  std::string text;
  while (log) {
    const std::size_t rest = text.size();
    text.resize(rest + kPiece);
    log.read(text.data() + rest, static_cast<std::streamsize>(kPiece));
    text.resize(rest + static_cast<std::size_t>(log.gcount()));
    const std::size_t whole = text.rfind('\n') + 1;
    if (whole > 0 && !take_lines(std::string_view(text).substr(0, whole), node, take)) {
      return false;
    }
    text.erase(0, whole);
  }
  return true;
}

}  // namespace

std::optional<protocol::Node> node_of_line(std::string_view line) {
  const std::size_t end = line.find('#');
  const std::size_t begin = line.rfind(' ', end);
  if (end == std::string_view::npos || begin == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view digits = line.substr(begin + 1, end - begin - 1);
  hal::CanFrame frame;
  const char* const last = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), last, frame.id, 16);
  if (error != std::errc{} || stop != last) {
    return std::nullopt;
  }
  constexpr std::size_t kStandardDigits = 3;
  frame.extended = digits.size() != kStandardDigits;
  return frame.extended ? node_of_diagnosis(frame) : node_of_plan(frame);
}

void RecordedFolder::read(std::optional<protocol::Node> node,
                          const std::function<bool(std::string_view)>& take) const {
  for (const std::filesystem::path& log : logs_in(folder_)) {
    if (!read_log(log, node, take)) {
      return;
    }
  }
}

}  // namespace host_sim::monitor
