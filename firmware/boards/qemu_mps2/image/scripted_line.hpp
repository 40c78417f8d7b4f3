#pragma once

#include <cstddef>
#include <span>

#include "hal/byte_stream.hpp"
#include "hal/slcan/byte_queue.hpp"

namespace firmware::qemu_mps2 {

/// A serial line with a scripted host at the other end: what the node writes goes on to `Line`,
/// what it reads is what the script types.
template <hal::ByteStream Line>
class ScriptedLine {
 public:
  explicit ScriptedLine(Line& line) : line_(line) {}

  /// False, and nothing has happened, where the node has not read enough of what came before.
  [[nodiscard]] bool type(std::span<const std::byte> text) {
    if (text.size() > typed_.free()) {
      return false;
    }
    typed_.push(text);
    return true;
  }
  void set_stalled(bool stalled) { stalled_ = stalled; }

  std::size_t try_read(std::span<std::byte> out) {
    std::size_t count = 0;
    while (count < out.size() && !typed_.empty()) {
      out[count++] = typed_.front().front();
      typed_.pop(1);
    }
    return count;
  }
  std::size_t try_write(std::span<const std::byte> in) {
    return stalled_ ? 0 : line_.try_write(in);
  }

 private:
  Line& line_;
  hal::slcan::ByteQueue<512> typed_;
  bool stalled_ = false;
};

}  // namespace firmware::qemu_mps2
