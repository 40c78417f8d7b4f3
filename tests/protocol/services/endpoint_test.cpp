#include "firmware/protocol/uds/endpoint.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/protocol/services/model_device.hpp"
#include "tests/protocol/services/requests.hpp"
#include "tests/protocol/services/tester.hpp"

namespace protocol::testing {
namespace {

Order fresh_order(Tester<ModelDevice>& tester) {
  const auto answer = tester.ask(hex("22 02 41 02 40"));
  Order order;
  if (answer && answer->size() == 25) {
    std::copy_n(answer->begin() + 3, order.nonce.size(), order.nonce.begin());
    order.counter = lifemodel::ByteReader(std::span(*answer).last(4)).u32();
  }
  return order;
}

TEST(Endpoint, AnswersOverTheBus) {
  ModelDevice device(2);
  Tester tester(device, kNode, kKey);
  EXPECT_EQ(tester.ask(hex("3e 00")), hex("7e 00"));
  EXPECT_EQ(tester.ask(hex("3e 80")), std::nullopt);
  const auto life = tester.ask(hex("22 02 00"));
  ASSERT_TRUE(life);
  EXPECT_EQ(life->size(), 64u);
  EXPECT_EQ(tester.ask(hex("22 ff ff")), hex("7f 22 31"));
}

TEST(Endpoint, DoesWhatIsProvenOverTheBus) {
  ModelDevice device(2);
  Tester tester(device, kNode, kKey);
  EXPECT_EQ(tester.ask(start_request(fresh_order(tester))), hex("71 01 02 01"));
  EXPECT_EQ(device.life.records[0].epoch, 2);
  Order order = fresh_order(tester);
  order.routine = 0x0202;
  order.arguments = hex("01") + paper_block();
  EXPECT_EQ(tester.ask(start_request(order)), hex("71 01 02 02"));
  EXPECT_EQ(to_bytes(device.life.blocks[1]), paper_block());
}

TEST(Endpoint, AnOversizedTransferIsRefusedCountedAndLogged) {
  ModelDevice device(2);
  Tester tester(device, kNode, kKey);
  const ModelLife life = device.life;
  EXPECT_EQ(tester.ask(counting(129)), std::nullopt);
  EXPECT_EQ(device.life, life);
  EXPECT_EQ(tester.node().counts().oversized, 1u);
  EXPECT_EQ(tester.node().server().counts().refused, 1u);
  ASSERT_EQ(device.lines.size(), 1u);
  EXPECT_EQ(device.lines[0].event, storage::Event::rejected);
  EXPECT_EQ(device.lines[0].detail, 0u);
  EXPECT_EQ(tester.ask(hex("3e 00")), hex("7e 00"));
}

TEST(Endpoint, FinishesAnAnswerBeforeTheNextRequest) {
  ModelDevice device(1);
  uds::Endpoint<ModelDevice> node(device, kNode, kKey);
  node.start({});
  const auto hear = [&node](std::string_view data) {
    hal::CanFrame frame{.id = isotp::Address::to_node(kNode).id(), .extended = true};
    for (const std::byte byte : hex(data)) {
      frame.data[frame.length++] = byte;
    }
    node.on_frame(frame, {});
  };
  hear("03 22 f1 95");
  node.poll({});
  EXPECT_TRUE(node.ready({}));
  hear("02 3e 00");
  node.poll({});
  const auto first = node.next_frame({});
  ASSERT_TRUE(first);
  EXPECT_EQ(first->data[1], std::byte{0x62});
  EXPECT_FALSE(node.ready({}));
  node.poll({});
  const auto second = node.next_frame({});
  ASSERT_TRUE(second);
  EXPECT_EQ(second->data[1], std::byte{0x7e});
}

RC_GTEST_PROP(EndpointProperty, OnABadBusACommandIsDoneOnceOrNotAtAll, ()) {
  const auto fates = rc::gen::container<std::vector<Fate>>(rc::gen::weightedElement<Fate>(
      {{20, Fate::arrives}, {1, Fate::lost}, {1, Fate::twice}, {1, Fate::overtaken}}));
  ModelDevice device(2);
  Tester tester(device, kNode, kKey);
  tester.to_node = Channel(*fates);
  tester.to_client = Channel(*fates);
  const auto answer = tester.ask(start_request(fresh_order(tester)));
  const unsigned opened = device.life.records[0].epoch - 1u;
  RC_ASSERT(opened <= 1u);
  RC_ASSERT(answer != hex("71 01 02 01") || opened == 1u);
  RC_ASSERT(device.life.records[1] == ModelDevice(2).life.records[1]);

  tester.to_node = Channel();
  tester.to_client = Channel();
  for (int i = 0; i < 30; ++i) {
    tester.step(hal::milliseconds(100));
  }
  RC_ASSERT(tester.ask(hex("3e 00")) == hex("7e 00"));
}

}  // namespace
}  // namespace protocol::testing
