#include "host_sim/monitor/http/frame_archive.hpp"

#include <charconv>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/isotp/pdu.hpp"
#include "firmware/protocol/schema/plan.hpp"
#include "host_sim/monitor/bus/frame_log.hpp"
#include "host_sim/monitor/record/log_folder.hpp"

namespace host_sim::monitor {
namespace {

// The oldest go a piece at a time; readers share the pieces.
constexpr std::size_t kPieces = 32;

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

/// Hands `lines`, whole ones, to `take`: all, or those of `node` alone. Whether it wants more.
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

RecentFrames::RecentFrames(std::string interface, std::size_t most)
    : interface_(std::move(interface)), piece_(most / kPieces) {}

void RecentFrames::see(const SeenFrame& seen) {
  const std::string line = log_line(seen, interface_);
  const std::lock_guard lock(mutex_);
  if (!open_.empty() && open_.size() + line.size() > piece_) {
    if (full_.size() + 1 == kPieces) {
      full_.pop_front();
    }
    full_.push_back(std::make_shared<const std::string>(std::exchange(open_, {})));
  }
  open_ += line;
}

void RecentFrames::read(std::optional<protocol::Node> node,
                        const std::function<bool(std::string_view)>& take) const {
  std::vector<std::shared_ptr<const std::string>> pieces;
  {
    const std::lock_guard lock(mutex_);
    pieces.assign(full_.begin(), full_.end());
    pieces.push_back(std::make_shared<const std::string>(open_));
  }
  for (const auto& piece : pieces) {
    if (!take_lines(*piece, node, take)) {
      return;
    }
  }
}

void RecordedFolder::read(std::optional<protocol::Node> node,
                          const std::function<bool(std::string_view)>& take) const {
  flush_();
  for (const std::filesystem::path& log : logs_in(folder_)) {
    if (!read_log(log, node, take)) {
      return;
    }
  }
}

}  // namespace host_sim::monitor
