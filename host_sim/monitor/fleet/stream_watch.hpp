#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "firmware/protocol/e2e.hpp"
#include "firmware/protocol/schema/frame.hpp"
#include "hal/can_frame.hpp"
#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

/// Whether the frames of a stream are of two speakers, each of which counts its own.
///
/// A frame continues the count that it is the next one of. Late, doubled and lost frames make no
/// second count that continues: there are two speakers where two counts, in turn and neither
/// silent, have continued kInARow times without a gap.
class Speakers {
 public:
  static constexpr int kInARow = 8;

  /// `most_ns`: how long a speaker may be silent.
  void hear(std::uint8_t counter, const hal::CanFrame& frame, std::int64_t time_ns,
            std::int64_t most_ns);
  [[nodiscard]] bool two() const { return two_; }

 private:
  struct Count {
    std::uint8_t counter = 0;
    std::int64_t time_ns = 0;
    int in_a_row = 0;
    int passed_over = 0;  ///< frames of others since
    bool is_there = false;
  };

  [[nodiscard]] Count& count_of(std::uint8_t counter);

  std::array<Count, 2> counts_;
  hal::CanFrame last_;
  std::int64_t last_ns_ = 0;
  bool two_ = false;
};

/// Follows the frames of one kind of one node: checks them end to end and counts what became of
/// them. A stream without protection has its length checked alone.
class StreamWatch {
 public:
  StreamWatch(const protocol::schema::Frame& frame, protocol::Node node);

  /// What the frame is worth. @pre it has the identifier of the stream
  protocol::e2e::Status take(const hal::CanFrame& frame, std::int64_t time_ns, StreamView& view);

  /// The last genuine frame is, bit for bit, the one before it.
  [[nodiscard]] bool is_the_same_again() const { return same_again_; }
  /// Two speakers have been heard at once.
  [[nodiscard]] bool two_speakers() const { return speakers_.two(); }

  /// The node has begun anew, and its counters with it.
  void begin_anew();

 private:
  protocol::e2e::Status check(const hal::CanFrame& frame, std::int64_t time_ns, StreamView& view);
  void count_interval(std::int64_t time_ns, StreamView& view);

  const protocol::schema::Frame& frame_;
  std::optional<protocol::e2e::Stream> stream_;
  std::optional<protocol::e2e::Checker> checker_;
  std::optional<std::int64_t> last_ns_;  ///< of the last genuine frame
  std::optional<hal::CanFrame> last_;
  bool same_again_ = false;
  Speakers speakers_;
};

/// What frames of the stream are called in a view that is empty as yet.
StreamView empty_stream_view(const protocol::schema::Frame& frame);

}  // namespace host_sim::monitor
