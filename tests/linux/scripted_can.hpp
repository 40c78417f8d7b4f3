#pragma once

#include <cerrno>
#include <deque>
#include <string>
#include <vector>

#include "hal/linux/can_calls.hpp"
#include "hal/linux/device_error.hpp"

namespace hal::linux_os::test {

/// Calls of the kernel with scripted answers.
struct ScriptedCan {
  void open(const std::string& name, std::span<const CanFilter> wanted) {
    if (open_error != 0) {
      throw DeviceError(name, "missing", "another");
    }
    filters.assign(wanted.begin(), wanted.end());
  }
  int reopen() {
    ++reopens;
    closed = closed && reopen_error != 0;
    return reopen_error;
  }
  void close() { closed = true; }
  int send(const ::can_frame& frame) {
    if (send_error == 0) {
      sent.push_back(frame);
    }
    return send_error;
  }
  CanReceipt receive() {
    if (waiting.empty()) {
      CanReceipt nothing;
      nothing.error = receive_error;
      return nothing;
    }
    const CanReceipt receipt = waiting.front();
    waiting.pop_front();
    return receipt;
  }
  [[nodiscard]] bool is_up() const { return up; }
  CanRestart restart() {
    ++restarts;
    return restart_answer;
  }

  int open_error = 0;
  int reopen_error = 0;
  int send_error = 0;
  int receive_error = EAGAIN;
  bool up = true;
  bool closed = false;
  CanRestart restart_answer = CanRestart::asked;
  int reopens = 0;
  int restarts = 0;
  std::vector<CanFilter> filters;
  std::vector<::can_frame> sent;
  std::deque<CanReceipt> waiting;
};

inline CanReceipt received(std::uint32_t id, std::uint8_t first = 0) {
  CanReceipt receipt;
  receipt.frame.can_id = id;
  receipt.frame.can_dlc = 8;
  receipt.frame.data[0] = first;
  return receipt;
}

}  // namespace hal::linux_os::test
