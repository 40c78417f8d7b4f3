// Two links and a bus between them that loses, repeats and reorders frames.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "firmware/protocol/isotp/link.hpp"
#include "tests/protocol/services/bytes.hpp"
#include "tests/protocol/services/channel.hpp"

namespace protocol::testing {
namespace {

using isotp::Address;
using isotp::Counts;
using isotp::Pace;

constexpr std::size_t kMost = 128;

struct Bus {
  Bus(Pace pace, std::vector<Fate> there, std::vector<Fate> back)
      : tester(Address::to_node(5)),
        node(Address::to_tester(5), pace),
        to_node(std::move(there)),
        to_tester(std::move(back)) {}

  void step(hal::Time time) {
    now = now + time;
    if (const auto frame = tester.next_frame(now)) {
      to_node.put(*frame);
    }
    if (const auto frame = node.next_frame(now)) {
      to_tester.put(*frame);
    }
    while (const auto frame = to_node.take()) {
      node.on_frame(*frame, now);
    }
    while (const auto frame = to_tester.take()) {
      tester.on_frame(*frame, now);
    }
  }
  /// Until the sender has done and every frame and timeout is through.
  void drain() {
    for (int i = 0; i < 4000 && tester.sending(); ++i) {
      step(hal::milliseconds(1));
    }
    to_node.release();
    to_tester.release();
    for (int i = 0; i < 5; ++i) {
      step(hal::milliseconds(500));
    }
  }

  hal::Time now{};
  isotp::Link<kMost> tester;
  isotp::Link<kMost> node;
  Channel to_node;
  Channel to_tester;
};

std::uint32_t lost_messages(const Counts& counts) {
  return counts.interrupted + counts.wrong_sequence + counts.receive_timeout + counts.send_timeout +
         counts.send_refused;
}

rc::Gen<std::vector<Fate>> fates() {
  return rc::gen::container<std::vector<Fate>>(rc::gen::weightedElement<Fate>(
      {{12, Fate::arrives}, {1, Fate::lost}, {1, Fate::twice}, {1, Fate::overtaken}}));
}

Bytes message(std::size_t size) {
  return *rc::gen::container<Bytes>(
      size, rc::gen::map(rc::gen::arbitrary<std::uint8_t>(),
                         [](std::uint8_t value) { return std::byte{value}; }));
}

Pace any_pace() {
  return {.block_size = *rc::gen::inRange<std::uint8_t>(0, 20),
          .st_min = *rc::gen::element<std::uint8_t>(0, 1, 5, 0xf1, 0xf9)};
}

void expect_usable(Bus& bus) {
  bus.node.clear();
  bus.to_node = Channel();
  bus.to_tester = Channel();
  const Bytes sent = counting(kMost);
  RC_ASSERT(bus.tester.send(sent) == hal::Error::none);
  bus.drain();
  RC_ASSERT(to_bytes(bus.node.received()) == sent);
}

RC_GTEST_PROP(LinkProperty, AGoodBusBringsEveryMessage, ()) {
  Bus bus(any_pace(), {}, {});
  for (int i = 0; i < 3; ++i) {
    const Bytes sent = message(*rc::gen::inRange<std::size_t>(1, kMost + 1));
    RC_ASSERT(bus.tester.send(sent) == hal::Error::none);
    bus.drain();
    RC_ASSERT(to_bytes(bus.node.received()) == sent);
    bus.node.clear();
  }
  RC_ASSERT(lost_messages(bus.node.counts()) + lost_messages(bus.tester.counts()) == 0u);
}

RC_GTEST_PROP(LinkProperty, AMessageArrivesAsItWasSentOrIsReportedLost, ()) {
  Bus bus(any_pace(), *fates(), *fates());
  const Bytes sent = message(*rc::gen::inRange<std::size_t>(1, kMost + 1));
  RC_ASSERT(bus.tester.send(sent) == hal::Error::none);
  bus.drain();
  const Bytes received = to_bytes(bus.node.received());
  RC_CLASSIFY(received.empty(), "lost");
  if (received.empty()) {
    // Nobody but who waits for an answer can miss a message of one frame.
    RC_ASSERT((sent.size() <= isotp::kSingleBytes && bus.to_node.lost() > 0) ||
              lost_messages(bus.node.counts()) + lost_messages(bus.tester.counts()) > 0u);
  } else {
    RC_ASSERT(received == sent);
  }
  RC_ASSERT(!bus.tester.sending());
  expect_usable(bus);
}

RC_GTEST_PROP(LinkProperty, AnyFramesLeaveTheLinkUsable, ()) {
  Bus bus(any_pace(), {}, {});
  const auto frames = *rc::gen::container<std::vector<std::vector<std::uint8_t>>>(
      rc::gen::resize(8, rc::gen::arbitrary<std::vector<std::uint8_t>>()));
  for (const auto& bytes : frames) {
    hal::CanFrame frame{.id = Address::to_node(5).id(), .extended = true};
    for (std::size_t i = 0; i < bytes.size() && i < 8; ++i) {
      frame.data[frame.length++] = std::byte{bytes[i]};
    }
    bus.node.on_frame(frame, bus.now);
  }
  bus.drain();
  expect_usable(bus);
}

}  // namespace
}  // namespace protocol::testing
