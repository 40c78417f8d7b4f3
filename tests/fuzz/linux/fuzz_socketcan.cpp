// Whatever the kernel answers: frames that are well formed, counts that only grow, a state that
// fits.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "hal/linux/socketcan.hpp"
#include "tests/fuzz/io/require.hpp"
#include "tests/linux/scripted_can.hpp"

using hal::linux_os::BasicSocketCan;
using hal::linux_os::CanReceipt;
using hal::linux_os::CanRestart;
using hal::linux_os::test::ScriptedCan;
using host_sim::fuzz::require;

namespace {

constexpr std::array kErrors{0, ENOBUFS, EAGAIN, ENETDOWN, ENODEV, ENXIO, EIO};

CanReceipt receipt_of(std::span<const std::uint8_t> bytes) {
  CanReceipt receipt;
  std::memcpy(&receipt.frame, bytes.data(), std::min(bytes.size(), sizeof receipt.frame));
  return receipt;
}

void step(ScriptedCan& calls, BasicSocketCan<ScriptedCan>& port,
          std::span<const std::uint8_t> bytes) {
  const hal::CanStatus before = port.status();
  switch (bytes[0] % 4) {
    case 0:
      calls.waiting.push_back(receipt_of(bytes.subspan(1)));
      break;
    case 1: {
      calls.send_error = kErrors[bytes[1] % kErrors.size()];
      const std::size_t sent = calls.sent.size();
      const hal::Error error = port.send({});
      require((error == hal::Error::none) == (calls.sent.size() == sent + 1));
      require(before.state != hal::CanState::off || error != hal::Error::full);
      break;
    }
    case 2:
      calls.receive_error = bytes[1] % 2 == 0 ? EAGAIN : kErrors[1 + bytes[1] % 6];
      if (const auto frame = port.receive()) {
        require(frame->length <= 8);
        require(frame->id <= (frame->extended ? 0x1fff'ffffU : 0x7ffU));
      }
      break;
    default:
      calls.up = bytes[1] % 2 == 0;
      calls.reopen_error = bytes[1] % 3 == 0 ? ENODEV : 0;
      calls.restart_answer = static_cast<CanRestart>(bytes[2] % 5);
      if (port.recover() == hal::Error::none && calls.restart_answer != CanRestart::asked) {
        require(port.status().state != hal::CanState::off);
      }
      break;
  }
  require(port.status().bus_offs >= before.bus_offs);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ScriptedCan calls;
  BasicSocketCan<ScriptedCan> port(calls, "can0", {});
  constexpr std::size_t kStep = 17;
  for (std::size_t at = 0; at + kStep <= size; at += kStep) {
    step(calls, port, std::span(data + at, kStep));
  }
  return 0;
}
