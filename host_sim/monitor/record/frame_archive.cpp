#include "host_sim/monitor/record/frame_archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/isotp/pdu.hpp"
#include "firmware/protocol/schema/plan.hpp"
#include "hal/files/candump.hpp"
#include "hal/files/input_error.hpp"
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

/// Of the first line of `lines` that is whole and a frame; none where it is not among the first
/// few.
std::optional<std::int64_t> time_of_first(std::string_view lines) {
  constexpr int kMostLines = 16;
  for (int i = 0; i < kMostLines; ++i) {
    const std::size_t end = lines.find('\n');
    if (end == std::string_view::npos) {
      break;
    }
    try {
      const auto line = lines.substr(0, end);
      return static_cast<std::int64_t>(
          hal::files::parse_candump_line({.file = {}, .number = 0, .text = line}).time_us);
    } catch (const hal::files::InputError&) {
      lines.remove_prefix(end + 1);
    }
  }
  return std::nullopt;
}

/// From the first line on that begins at `offset` or later.
std::string_view from_line_at(std::string_view lines, std::size_t offset) {
  if (offset == 0) {
    return lines;
  }
  const std::size_t end = lines.find('\n', offset - 1);
  return end == std::string_view::npos ? std::string_view() : lines.substr(end + 1);
}

/// Adds a time to rising ones; those that are no earlier are of before the clock was set back.
void add_rising(std::vector<std::int64_t>& times_us, std::optional<std::int64_t> time_us) {
  if (!time_us) {
    return;
  }
  times_us.erase(std::lower_bound(times_us.begin(), times_us.end(), *time_us), times_us.end());
  times_us.push_back(*time_us);
}

/// A log in which lines are looked up by their place and time.
class LogPlaces {
 public:
  explicit LogPlaces(const std::filesystem::path& path) : log_(path, std::ios::binary) {
    log_.seekg(0, std::ios::end);
    const auto end = static_cast<std::streamoff>(log_.tellg());
    size_ = log_ && end > 0 ? static_cast<std::uint64_t>(end) : 0;
  }

  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// Of the first line that begins at `offset` or soon after it.
  std::optional<std::int64_t> time_at(std::uint64_t offset) {
    std::string text(kLook, '\0');
    const std::uint64_t begin = offset - (offset > 0 ? 1 : 0);
    log_.clear();
    log_.seekg(static_cast<std::streamoff>(begin));
    log_.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(log_.gcount(), 0)));
    return time_of_first(from_line_at(text, static_cast<std::size_t>(offset - begin)));
  }

  /// A place whose line is no later than `from_us`, less than kLook before the last such one; 0
  /// where none is.
  std::uint64_t place_of(std::int64_t from_us) {
    std::uint64_t low = 0;
    for (std::uint64_t high = size_; high - low > kLook;) {
      const std::uint64_t middle = low + (high - low) / 2;
      const auto time_us = time_at(middle);
      (time_us && *time_us <= from_us ? low : high) = middle;
    }
    return low;
  }

 private:
  static constexpr std::size_t kLook = std::size_t{16} << 10;

  std::ifstream log_;
  std::uint64_t size_ = 0;
};

bool read_log(const std::filesystem::path& path, std::uint64_t offset,
              std::optional<protocol::Node> node,
              const std::function<bool(std::string_view)>& take) {
  constexpr std::size_t kPiece = std::size_t{256} << 10;
  std::ifstream log(path, std::ios::binary);
  std::string text;
  if (offset > 0) {
    log.seekg(static_cast<std::streamoff>(offset - 1));
    std::getline(log, text);  // ends where the first line begins
    text.clear();
  }
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
      gone_ = true;
    }
    full_.push_back(std::make_shared<const std::string>(std::exchange(open_, {})));
  }
  open_ += line;
}

std::vector<RecentFrames::Piece> RecentFrames::pieces() const {
  const std::lock_guard lock(mutex_);
  std::vector<Piece> pieces(full_.begin(), full_.end());
  pieces.push_back(std::make_shared<const std::string>(open_));
  return pieces;
}

void RecentFrames::read(std::optional<protocol::Node> node,
                        const std::function<bool(std::string_view)>& take) const {
  for (const Piece& piece : pieces()) {
    if (!take_lines(*piece, node, take)) {
      return;
    }
  }
}

void RecentFrames::read_from(std::int64_t from_us,
                             const std::function<bool(std::string_view)>& take) const {
  const std::vector<Piece> kept = pieces();
  const auto last = std::find_if(kept.rbegin(), kept.rend(), [from_us](const Piece& piece) {
    const auto time_us = time_of_first(*piece);
    return time_us && *time_us <= from_us;
  });
  const auto first = last == kept.rend() ? kept.begin() : last.base() - 1;
  (void)std::all_of(first, kept.end(), [&](const Piece& piece) { return take(*piece); });
}

std::vector<std::int64_t> RecentFrames::times_us() const {
  constexpr std::size_t kOfPiece = kMostTimes / kPieces;
  std::vector<std::int64_t> times_us;
  for (const Piece& piece : pieces()) {
    for (std::size_t i = 0; i < kOfPiece; ++i) {
      add_rising(times_us, time_of_first(from_line_at(*piece, piece->size() * i / kOfPiece)));
    }
  }
  return times_us;
}

std::string RecentFrames::why_gone() const {
  const std::lock_guard lock(mutex_);
  return gone_ ? fmt::format("without --record the newest {} MiB are kept", piece_ * kPieces >> 20)
               : std::string();
}

void RecordedFolder::read(std::optional<protocol::Node> node,
                          const std::function<bool(std::string_view)>& take) const {
  flush_();
  for (const std::filesystem::path& log : logs_in(folder_)) {
    if (!read_log(log, 0, node, take)) {
      return;
    }
  }
}

void RecordedFolder::read_from(std::int64_t from_us,
                               const std::function<bool(std::string_view)>& take) const {
  flush_();
  const std::vector<std::filesystem::path> logs = logs_in(folder_);
  const auto last = std::find_if(logs.rbegin(), logs.rend(), [from_us](const auto& log) {
    const auto time_us = LogPlaces(log).time_at(0);
    return time_us && *time_us <= from_us;
  });
  const auto first = last == logs.rend() ? logs.begin() : last.base() - 1;
  for (auto log = first; log != logs.end(); ++log) {
    const std::uint64_t offset = log == first ? LogPlaces(*log).place_of(from_us) : 0;
    if (!read_log(*log, offset, std::nullopt, take)) {
      return;
    }
  }
}

std::vector<std::int64_t> RecordedFolder::times_us() const {
  flush_();
  const std::vector<std::filesystem::path> logs = logs_in(folder_);
  const std::size_t of_log =
      std::max<std::size_t>(kMostTimes / std::max<std::size_t>(logs.size(), 1), 1);
  const std::size_t apart = (logs.size() + kMostTimes - 1) / kMostTimes;
  std::vector<std::int64_t> times_us;
  for (std::size_t number = 0; number < logs.size(); number += apart) {
    LogPlaces log(logs[number]);
    for (std::size_t i = 0; i < of_log; ++i) {
      add_rising(times_us, log.time_at(log.size() * i / of_log));
    }
  }
  return times_us;
}

std::string RecordedFolder::why_gone() const {
  const std::vector<std::filesystem::path> logs = logs_in(folder_);
  return logs.empty() || is_first_log(logs.front())
             ? std::string()
             : "of the record the newest logs are kept, as many as --record-keep says";
}

}  // namespace host_sim::monitor
