/// A receiver of one node, as a display would be: checks each frame end to end and shows only what
/// passes. For every frame it writes a line: the frame, the verdict, and what is shown because of
/// it.
///
///   185#C4120B... ok life 1 31245 0 0 3
///   185#C4120B... repeated
///
/// life: state, damage in parts per billion, worst tendon, quality, flags of byte 7.
/// emergency: code, error register, damage in parts per million. page: number of the detail page.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <span>
#include <stdexcept>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/e2e.hpp"
#include "hal/linux/socketcan.hpp"

namespace {

using protocol::e2e::Checker;
using protocol::e2e::Status;
using protocol::e2e::stream_of;

const char* to_string(Status status) {
  switch (status) {
    case Status::initial:
      return "initial";
    case Status::ok:
      return "ok";
    case Status::ok_some_lost:
      return "ok_some_lost";
    case Status::repeated:
      return "repeated";
    case Status::wrong_sequence:
      return "wrong_sequence";
    case Status::wrong_crc:
      return "wrong_crc";
    case Status::wrong_length:
      return "wrong_length";
    case Status::other_frame:
      return "other_frame";
  }
  return "unknown";
}

unsigned flags_of(const protocol::LifeStatus& status) {
  return (status.storage_ok ? 1u : 0u) | (status.sensor_ok ? 2u : 0u) | (status.gap ? 4u : 0u) |
         (status.saturated ? 8u : 0u) | (status.overrun ? 16u : 0u) | (status.locked ? 32u : 0u);
}

void show(const hal::CanFrame& frame, const protocol::LifeStatus* /*kind*/) {
  if (const auto life = protocol::decode<protocol::LifeStatus>(frame)) {
    std::printf(" life %u %u %u %u %u", static_cast<unsigned>(life->state), life->damage_ppb,
                life->worst_tendon, static_cast<unsigned>(life->quality), flags_of(*life));
  }
}

void show(const hal::CanFrame& frame, const protocol::Emergency* /*kind*/) {
  if (const auto emergency = protocol::decode<protocol::Emergency>(frame)) {
    std::printf(" emergency %u %u %u", static_cast<unsigned>(emergency->code),
                emergency->error_register, emergency->damage_ppm);
  }
}

void show(const hal::CanFrame& frame, const protocol::detail::Identity* /*kind*/) {
  std::printf(" page %u", std::to_integer<unsigned>(frame.data[1]) >> 4);
}

template <class Message>
class Display {
 public:
  explicit Display(protocol::Node node) : checker_(stream_of<Message>(node)) {}

  /// True where the frame was one of this kind.
  bool take(const hal::CanFrame& frame) {
    const Status status = checker_.check(frame);
    if (status == Status::other_frame) {
      return false;
    }
    std::printf("%03X#", frame.id);
    for (const std::byte byte : frame.payload()) {
      std::printf("%02X", std::to_integer<unsigned>(byte));
    }
    std::printf(" %s", to_string(status));
    if (protocol::e2e::is_usable(status)) {
      show(frame, static_cast<const Message*>(nullptr));
    }
    std::printf("\n");
    std::fflush(stdout);
    return true;
  }

 private:
  Checker checker_;
};

void watch(const char* interface, protocol::Node node) {
  using namespace hal::linux_os;
  Display<protocol::LifeStatus> life(node);
  Display<protocol::Emergency> emergency(node);
  Display<protocol::detail::Identity> detail(node);
  const CanFilter everything{.id = 0, .mask = 0, .extended = false};
  CanCalls calls;
  SocketCan can(calls, interface, std::span(&everything, 1));
  constexpr std::timespec kPause{.tv_sec = 0, .tv_nsec = 2'000'000};
  for (;;) {
    while (const auto frame = can.receive()) {
      (void)(life.take(*frame) || emergency.take(*frame) || detail.take(*frame));
    }
    if (can.status().lost != 0) {
      throw std::runtime_error("the socket lost frames");
    }
    ::nanosleep(&kPause, nullptr);
  }
}

}  // namespace

int main(int count, char** arguments) {
  const int node = count == 3 ? std::atoi(arguments[2]) : 0;
  if (node < 1 || node > 127) {
    std::fprintf(stderr, "usage: kernel_receiver INTERFACE NODE, node 1 .. 127\n");
    return 2;
  }
  try {
    watch(arguments[1], static_cast<protocol::Node>(node));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
