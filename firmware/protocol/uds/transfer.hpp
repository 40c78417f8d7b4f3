#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/protocol/uds/data.hpp"
#include "firmware/protocol/uds/nrc.hpp"
#include "firmware/protocol/uds/table.hpp"
#include "lifemodel/extension/extended_block.hpp"

namespace protocol::uds {

inline constexpr std::uint8_t kRequestDownload = 0x34;
inline constexpr std::uint8_t kTransferData = 0x36;
inline constexpr std::uint8_t kTransferExit = 0x37;

/// Takes a parameter block that is longer than a request, in parts: RequestDownload, TransferData
/// and RequestTransferExit (ISO 14229-1, 15.2 .. 15.4).
///
///   34 00 21, tendon, size (2, the high byte first)    74 20, most bytes of a TransferData (2)
///   36, number of the part from 1 on, wraps; bytes     76, number
///   37                                                 77
///
/// Needs no authority, for it fills a memory of its own and nothing else: the routine that takes
/// the block from there is proven over every byte of it. The part before, sent again, is answered
/// again.
///
///   0x13  wrong length
///   0x24  nothing was requested, all of it is there, or at the exit not all of it
///   0x31  other format, no such tendon, or a size that no block has
///   0x71  more than was requested
///   0x73  another part is due
class Transfer {
 public:
  /// @pre the request begins with kRequestDownload
  Nrc request(std::span<const std::byte> request, std::uint8_t tendons, Answer& answer) {
    constexpr std::uint8_t kPlain = 0x00;
    constexpr std::uint8_t kSizeOf2AddressOf1 = 0x21;
    constexpr std::uint8_t kLengthOf2 = 0x20;
    if (request.size() != 6) {
      return Nrc::wrong_length;
    }
    const auto tendon = static_cast<std::uint8_t>(request[3]);
    const auto size = static_cast<std::size_t>((static_cast<unsigned>(request[4]) << 8) |
                                               static_cast<unsigned>(request[5]));
    if (request[1] != std::byte{kPlain} || request[2] != std::byte{kSizeOf2AddressOf1} ||
        tendon >= tendons || size < lifemodel::kBlockBytes ||
        size > lifemodel::kMostExtendedBytes) {
      return Nrc::request_out_of_range;
    }
    state_ = State::filling;
    tendon_ = tendon;
    size_ = size;
    filled_ = 0;
    part_ = 0;
    answer.u8(kRequestDownload + kPositive);
    answer.u8(kLengthOf2);
    answer.identifier(kMostMessageBytes);
    return Nrc::none;
  }

  /// @pre the request begins with kTransferData
  Nrc take(std::span<const std::byte> request, Answer& answer) {
    if (request.size() < 3) {
      return Nrc::wrong_length;
    }
    if (state_ != State::filling) {
      return Nrc::request_sequence_error;
    }
    const auto part = static_cast<std::uint8_t>(request[1]);
    const bool again = part == part_ && filled_ != 0;
    if (!again) {
      if (part != static_cast<std::uint8_t>(part_ + 1)) {
        return Nrc::wrong_block_sequence_counter;
      }
      const auto bytes = request.subspan(2);
      if (bytes.size() > size_ - filled_) {
        return Nrc::transfer_data_suspended;
      }
      std::ranges::copy(bytes, bytes_.begin() + static_cast<std::ptrdiff_t>(filled_));
      filled_ += bytes.size();
      part_ = part;
    }
    answer.u8(kTransferData + kPositive);
    answer.u8(part);
    return Nrc::none;
  }

  /// @pre the request begins with kTransferExit
  Nrc exit(std::span<const std::byte> request, Answer& answer) {
    if (request.size() != 1) {
      return Nrc::wrong_length;
    }
    if (state_ != State::filling || filled_ != size_) {
      return Nrc::request_sequence_error;
    }
    state_ = State::whole;
    answer.u8(kTransferExit + kPositive);
    return Nrc::none;
  }

  /// The block that was transferred for a tendon; empty while there is none.
  [[nodiscard]] std::span<const std::byte> block(std::uint8_t tendon) const {
    return std::span(bytes_).first(state_ == State::whole && tendon_ == tendon ? size_ : 0);
  }
  /// It has been used.
  void clear() { state_ = State::idle; }

 private:
  enum class State : std::uint8_t { idle, filling, whole };

  State state_ = State::idle;
  std::uint8_t tendon_ = 0;
  std::uint8_t part_ = 0;  ///< the last that came
  std::size_t size_ = 0;
  std::size_t filled_ = 0;
  std::array<std::byte, lifemodel::kMostExtendedBytes> bytes_{};
};

}  // namespace protocol::uds
