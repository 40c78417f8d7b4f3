// Whatever arrives: a Checker takes a frame for good only with the CRC of its stream and the
// counter in its window, and its counts add up.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/e2e.hpp"

namespace {

using namespace protocol;
using e2e::Status;

void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

/// CRC-8H2F a bit at a time, beside the one with a table.
std::uint8_t crc_bit_by_bit(const hal::CanFrame& frame, std::size_t crc_byte,
                            std::uint8_t data_id) {
  std::uint32_t remainder = 0xff;
  for (std::size_t i = 0; i <= 8; ++i) {
    if (i == crc_byte) {
      continue;
    }
    remainder ^= i < 8 ? std::to_integer<std::uint32_t>(frame.data[i]) : data_id;
    for (int bit = 0; bit < 8; ++bit) {
      remainder = (remainder << 1) ^ ((remainder & 0x80) != 0 ? 0x12f : 0);
    }
  }
  return static_cast<std::uint8_t>(~remainder);
}

/// What a Checker has to say, kept in the plainest way.
class Model {
 public:
  Model(const e2e::Stream& stream, std::uint8_t max_delta)
      : stream_(stream), max_delta_(max_delta) {}

  Status expect(const hal::CanFrame& frame) {
    if (frame.extended || frame.id != stream_.id) {
      return Status::other_frame;
    }
    if (frame.length != 8) {
      return Status::wrong_length;
    }
    const unsigned counter = std::to_integer<unsigned>(frame.data[stream_.crc_byte + 1u]) % 16;
    const std::uint8_t id = stream_.data_ids.at(static_cast<std::uint8_t>(counter));
    if (frame.data[stream_.crc_byte] != std::byte{crc_bit_by_bit(frame, stream_.crc_byte, id)}) {
      return Status::wrong_crc;
    }
    const auto last = last_;
    last_ = counter;
    if (!last) {
      return Status::initial;
    }
    for (unsigned delta = 0; delta <= max_delta_; ++delta) {
      if ((*last + delta) % 16 == counter) {
        return delta == 0 ? Status::repeated : delta == 1 ? Status::ok : Status::ok_some_lost;
      }
    }
    return Status::wrong_sequence;
  }

 private:
  e2e::Stream stream_;
  unsigned max_delta_;
  std::optional<unsigned> last_;
};

/// The next frame out of the bytes: sent by a Protector and perhaps changed, or made up.
class Traffic {
 public:
  Traffic(const std::uint8_t* data, std::size_t size, const e2e::Stream& stream)
      : data_(data), size_(size), stream_(stream), protector_(stream) {}

  std::uint8_t byte() { return at_ < size_ ? data_[at_++] : std::uint8_t{0}; }
  bool ended() const { return at_ >= size_; }

  hal::CanFrame next() {
    hal::CanFrame frame{.id = stream_.id, .length = 8};
    const std::uint8_t kind = byte();
    for (std::byte& b : frame.data) {
      b = std::byte{byte()};
    }
    for (int lost = 0; lost <= kind % 8; ++lost) {
      protector_.protect(frame);
    }
    switch (kind / 8 % 8) {
      case 0:
        return previous_;
      case 1:
        frame.data[byte() % 8] ^= std::byte{byte()};
        break;
      case 2:
        frame.length = byte() % 9;
        break;
      case 3:
        frame.id ^= byte();
        frame.extended = byte() % 2 != 0;
        break;
      default:
        break;
    }
    return previous_ = frame;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
  e2e::Stream stream_;
  e2e::Protector protector_;
  hal::CanFrame previous_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto node = static_cast<Node>(size > 0 ? 1 + data[0] % 127 : 1);
  const e2e::Stream stream =
      node % 2 == 0 ? e2e::stream_of<LifeStatus>(node) : e2e::stream_of<Emergency>(node);
  const auto max_delta = static_cast<std::uint8_t>(1 + node % 14);
  Traffic traffic(data, size, stream);
  traffic.byte();
  e2e::Checker checker(stream, max_delta);
  Model model(stream, max_delta);
  std::uint32_t counted = 0;
  while (!traffic.ended()) {
    const hal::CanFrame frame = traffic.next();
    const Status status = checker.check(frame);
    require(status == model.expect(frame));
    counted += status == Status::other_frame ? 0 : 1;
    const e2e::Counts& counts = checker.counts();
    require(counts.good + counts.repeated + counts.wrong_sequence + counts.damaged == counted);
    require(counts.lost <= counts.good * (max_delta - 1u));
  }
  return 0;
}
