#include "host_sim/monitor/http/recent_frames.hpp"

#include <utility>
#include <vector>

#include "host_sim/monitor/http/frame_lines.hpp"
#include "host_sim/monitor/record/log_line.hpp"

namespace host_sim::monitor {
namespace {

// The oldest go a piece at a time; readers share the pieces.
constexpr std::size_t kPieces = 32;

}  // namespace

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

}  // namespace host_sim::monitor
