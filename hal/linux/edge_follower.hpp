#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/error.hpp"

namespace hal::linux_os {

/// An edge of a line as the kernel reports it; both numbers count from 1 without holes.
struct Edge {
  bool asserted = false;
  std::uint32_t request_number = 0;  ///< among the edges of all lines of the request
  std::uint32_t line_number = 0;     ///< among the edges of this line
  std::uint64_t time_ns = 0;         ///< CLOCK_MONOTONIC
};

/// Gives the edges that wait, oldest first, up to the size of `out`, and 0 without waiting where
/// there are none; level() is the level of this moment.
template <class T>
concept EdgeSource = requires(T& source, std::span<Edge> out) {
  { source.read(out) } -> std::same_as<Result<std::size_t>>;
  { source.level() } -> std::same_as<Result<bool>>;
};

/// Knows from its edges whether a line is asserted. Where numbers are missing the kernel has lost
/// edges: the level is read again.
template <EdgeSource SourceT>
class EdgeFollower {
 public:
  explicit EdgeFollower(SourceT& source) : source_(source) {}

  /// True where the line is asserted, became so at any time since the last call, or may have become
  /// so because edges were lost. Bounded: at most kMostEdges edges, the rest next time.
  Result<bool> asserted() {
    bool was = false;
    bool reread = !known_;
    for (std::size_t taken = 0; taken < kMostEdges;) {
      const Result<std::size_t> count = source_.read(edges_);
      if (!count) {
        return lose(count.error());
      }
      if (*count == 0) {
        break;
      }
      taken += *count;
      for (const Edge& edge : std::span(edges_).first(*count)) {
        reread = take(edge) || reread;
        was = was || edge.asserted;
      }
    }
    if (reread) {
      const Result<bool> level = source_.level();
      if (!level) {
        return lose(level.error());
      }
      was = was || known_;
      level_ = *level;
      known_ = true;
    }
    return was || level_;
  }

  [[nodiscard]] std::uint32_t lost_edges() const { return lost_; }
  [[nodiscard]] std::uint64_t last_edge_ns() const { return last_edge_ns_; }

 private:
  static constexpr std::size_t kMostEdges = 64;

  // True where edges before this one were lost.
  bool take(const Edge& edge) {
    const std::uint32_t missing = edge.line_number - next_line_;
    const bool lost = missing != 0 || edge.request_number != next_request_;
    lost_ += missing;
    next_line_ = edge.line_number + 1;
    next_request_ = edge.request_number + 1;
    level_ = edge.asserted;
    last_edge_ns_ = edge.time_ns;
    return lost;
  }

  Error lose(Error error) {
    known_ = false;
    return error;
  }

  SourceT& source_;
  std::array<Edge, 16> edges_{};
  std::uint32_t next_line_ = 1;
  std::uint32_t next_request_ = 1;
  std::uint32_t lost_ = 0;
  std::uint64_t last_edge_ns_ = 0;
  bool level_ = false;
  bool known_ = false;  ///< `level_` has been read
};

}  // namespace hal::linux_os
