#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "hal/byte_stream.hpp"

namespace slcan_test {

/// A serial line with the host's end in the hands of the test.
class Wire {
 public:
  std::size_t try_read(std::span<std::byte> out) {
    const std::size_t count = std::min(out.size(), to_node_.size());
    std::copy_n(to_node_.begin(), count, reinterpret_cast<char*>(out.data()));
    to_node_.erase(0, count);
    return count;
  }
  std::size_t try_write(std::span<const std::byte> in) {
    const std::size_t count = std::min(in.size(), room_);
    to_host_.append(reinterpret_cast<const char*>(in.data()), count);
    room_ -= count;
    return count;
  }

  void host_writes(std::string_view text) { to_node_ += text; }
  /// All that has come since the last call.
  std::string host_reads() { return std::exchange(to_host_, {}); }
  /// How many more bytes the line takes from the node.
  void set_room(std::size_t bytes) { room_ = bytes; }
  [[nodiscard]] std::size_t unread() const { return to_node_.size(); }

 private:
  std::string to_node_;
  std::string to_host_;
  std::size_t room_ = 1'000'000'000;
};
static_assert(hal::ByteStream<Wire>);

}  // namespace slcan_test
