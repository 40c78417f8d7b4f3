#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hal/clock.hpp"
#include "lifemodel/support/bytes.hpp"

/// Files that a recording is made of. All words are little-endian.
namespace boards::qemu_mps2 {

inline constexpr std::size_t kTendons = 2;

/// Samples: this header, then for each sample one word a tendon, the raw motor current or
/// hal::qemu_mps2::kNoSample.
struct ProfileHeader {
  static constexpr std::uint32_t kMagic = 0x46504c54;  ///< "TLPF"
  static constexpr std::uint32_t kVersion = 1;
  static constexpr std::size_t kBytes = 16;

  std::uint32_t magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t tendons = kTendons;
  std::uint32_t sample_period_us = 1'000;  ///< 10 .. 1,000
};

inline constexpr std::uint32_t kShortestPeriod_us = 10;
inline constexpr std::uint32_t kLongestPeriod_us = 1'000;

enum class EventKind : std::uint32_t {
  line = 1,        ///< the host writes this text, padded with zeros
  emergency_stop,  ///< pulled where the first word is not 0
  sensor_failed,   ///< where the first word is not 0
  missed,          ///< the control loop leaves out as many periods as the first word says
  stalled,         ///< the serial line takes nothing more where the first word is not 0
};

/// What happens besides, in the order of time: u32 at_ms, u32 kind, 32 bytes of payload each.
struct Event {
  static constexpr std::size_t kBytes = 40;
  static constexpr std::size_t kPayloadBytes = 32;

  std::uint32_t at_ms = 0;
  EventKind kind = EventKind::line;
  std::array<std::byte, kPayloadBytes> payload{};
};

/// A file that is read from its begin to its end; read() gives fewer bytes than asked for only
/// there.
template <class T>
concept Source = requires(T& source, std::span<std::byte> out) {
  { source.read(out) } -> std::same_as<std::size_t>;
};

/// A file that is written; write() is true where all bytes were.
template <class T>
concept Sink = requires(T& sink, std::span<const std::byte> bytes) {
  { sink.write(bytes) } -> std::same_as<bool>;
};

using Row = std::array<std::int32_t, kTendons>;

/// Reads the samples of a recording, many at a time.
template <Source SourceT>
class Profile {
 public:
  explicit Profile(SourceT& source) : source_(source) {}

  /// What is wrong with the file, in words; null where nothing is. Before all else.
  const char* open() {
    std::array<std::byte, ProfileHeader::kBytes> bytes{};
    if (source_.read(bytes) != bytes.size()) {
      return "the profile is shorter than its header of 16 bytes";
    }
    lifemodel::ByteReader in(bytes);
    if (in.u32() != ProfileHeader::kMagic) {
      return "the profile does not begin with TLPF";
    }
    if (in.u32() != ProfileHeader::kVersion) {
      return "the profile is of another version; accepted: 1";
    }
    if (in.u32() != kTendons) {
      return "the profile is for another number of tendons; accepted: 2";
    }
    period_us_ = in.u32();
    if (period_us_ < kShortestPeriod_us || period_us_ > kLongestPeriod_us) {
      return "the sample period of the profile is out of range; accepted: 10 .. 1000 us";
    }
    return nullptr;
  }

  [[nodiscard]] std::uint32_t sample_period_us() const { return period_us_; }

  /// The next sample of all tendons; nothing at the end.
  std::optional<Row> next() {
    if (at_ == size_) {
      size_ = source_.read(chunk_) / kRowBytes * kRowBytes;
      at_ = 0;
    }
    if (at_ == size_) {
      return std::nullopt;
    }
    lifemodel::ByteReader in{std::span(chunk_).subspan(at_, kRowBytes)};
    at_ += kRowBytes;
    Row row{};
    for (std::int32_t& sample : row) {
      sample = in.i32();
    }
    return row;
  }

 private:
  static constexpr std::size_t kRowBytes = 4 * kTendons;

  SourceT& source_;
  std::array<std::byte, 512 * kRowBytes> chunk_{};
  std::size_t size_ = 0;
  std::size_t at_ = 0;
  std::uint32_t period_us_ = 0;
};

/// Reads the events of a recording one after another. Without a source there are none.
template <Source SourceT>
class Script {
 public:
  explicit Script(SourceT* source) : source_(source), ended_(source == nullptr) {}

  /// The next event whose time has come.
  std::optional<Event> due(hal::Time now) {
    if (!next_ && !ended_) {
      read();
    }
    if (!next_ || hal::milliseconds(next_->at_ms) > now) {
      return std::nullopt;
    }
    const std::optional<Event> event = next_;
    next_.reset();
    return event;
  }

 private:
  void read() {
    std::array<std::byte, Event::kBytes> bytes{};
    ended_ = source_->read(bytes) != bytes.size();
    if (ended_) {
      return;
    }
    lifemodel::ByteReader in(bytes);
    Event event;
    event.at_ms = in.u32();
    event.kind = static_cast<EventKind>(in.u32());
    std::ranges::copy(std::span(bytes).last(Event::kPayloadBytes), event.payload.begin());
    next_ = event;
  }

  SourceT* source_;
  std::optional<Event> next_;
  bool ended_;
};

}  // namespace boards::qemu_mps2
