#include "firmware/protocol/uds/server.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/protocol/services/bytes.hpp"
#include "tests/protocol/services/model_device.hpp"
#include "tests/protocol/services/requests.hpp"
#include "tests/protocol/services/tester.hpp"

namespace protocol::testing {
namespace {

class ServerTest : public ::testing::Test {
 protected:
  ServerTest() { server_.start({}); }

  Bytes ask(const Bytes& request, std::size_t room = 128) {
    Bytes response(room);
    response.resize(server_.handle(request, now_, response));
    return response;
  }
  Bytes ask(std::string_view request, std::size_t room = 128) { return ask(hex(request), room); }

  hal::Time now_ = hal::seconds(1);
  ModelDevice device_{2};
  uds::Server<ModelDevice> server_{device_, kNode, kKey};
};

TEST_F(ServerTest, TesterPresent) {
  EXPECT_EQ(ask("3e 00"), hex("7e 00"));
  EXPECT_EQ(ask("3e 80"), Bytes{});
  EXPECT_EQ(ask("3e"), hex("7f 3e 13"));
  EXPECT_EQ(ask("3e 01"), hex("7f 3e 12"));
  EXPECT_EQ(ask("3e 81"), hex("7f 3e 12"));
  EXPECT_EQ(ask("3e 00 00"), hex("7f 3e 13"));
}

TEST_F(ServerTest, OtherServicesAreNotThere) {
  EXPECT_EQ(ask(""), Bytes{});
  for (unsigned service = 0; service < 256; ++service) {
    const bool there = service == 0x22 || service == 0x31 || service == 0x34 || service == 0x36 ||
                       service == 0x37 || service == 0x3e;
    if (!there) {
      EXPECT_EQ(ask(Bytes{static_cast<std::byte>(service), std::byte{1}}),
                (Bytes{std::byte{0x7f}, static_cast<std::byte>(service), std::byte{0x11}}));
    }
  }
  EXPECT_EQ(server_.counts(), uds::AuthorityCounts{});
}

TEST_F(ServerTest, ReadsTheLifeRecord) {
  EXPECT_EQ(ask("22 02 01"), hex("62 02 01"
                                 "28 00 00 00"  // sequence 40
                                 "01 08 02 00"  // tendon, flags, epoch
                                 "00 65 cd 1d"  // 500,000,000
                                 "00 2f 68 59"  // 1,500,000,000
                                 "00 00 00 00 00 00 00 00 00 00 00 00 80 00 00 00"  // 2^103
                                 "00 00 00 00 00 00 00 00 00 00 00 00 80 01 00 00"
                                 "02 00 00 00 01 00 00 00"
                                 "01 ee ff c0"
                                 "00"));
  device_.life.records[1].past_lost = true;
  EXPECT_EQ(ask("22 02 01").back(), std::byte{1});
}

TEST_F(ServerTest, ReadsWhatElseThereIs) {
  EXPECT_EQ(ask("22 02 20"), hex("62 02 20 00 ee ff c0"));
  EXPECT_EQ(ask("22 02 21"), hex("62 02 21 01 ee ff c0"));
  EXPECT_EQ(ask("22 02 40"), hex("62 02 40 29 00 00 00"));
  EXPECT_EQ(ask("22 f1 8c"), hex("62 f1 8c e0 e1 e2 e3 e4 e5 e6 e7 e8 e9 ea eb"));
  EXPECT_EQ(ask("22 f1 95"), hex("62 f1 95 01 23"));
}

TEST_F(ServerTest, ReadsTheLog) {
  EXPECT_EQ(ask("22 10 00"), hex("7f 22 31"));
  device_.lines = {{.number = 0, .sequence = 1, .event = storage::Event::epoch_opened},
                   {.number = 1,
                    .sequence = 0x12345678,
                    .event = storage::Event::wrong_mac,
                    .tendon = 3,
                    .epoch = 0x0405,
                    .detail = 0x0201}};
  EXPECT_EQ(ask("22 10 01"), hex("62 10 01 01 00 00 00 78 56 34 12 03 03 05 04 01 02 00 00"));
  EXPECT_EQ(ask("22 10 02"), hex("7f 22 31"));
  EXPECT_EQ(ask("22 1f ff"), hex("7f 22 31"));
}

TEST_F(ServerTest, EachReadIssuesAFreshNonce) {
  const Bytes first = ask("22 02 41");
  const Bytes second = ask("22 02 41");
  EXPECT_EQ(first, hex("62 02 41 01000000 01000000 01000000 01000000"));
  EXPECT_EQ(second, hex("62 02 41 02000000 02000000 02000000 02000000"));
}

TEST_F(ServerTest, ABrokenSourceIssuesNoNonce) {
  device_.random_fault = hal::Error::failed;
  EXPECT_EQ(ask("22 02 41"), hex("7f 22 22"));
  device_.random_fault = hal::Error::none;
  EXPECT_EQ(ask("22 02 41").size(), 19u);
  device_.stuck_random = true;
  EXPECT_EQ(ask("22 02 41"), hex("7f 22 22"));
}

TEST_F(ServerTest, ReadsSeveralAndLeavesOutWhatIsNotThere) {
  EXPECT_EQ(ask("22 02 40 ff ff f1 95 02 22"), hex("62 02 40 29 00 00 00 f1 95 01 23"));
  EXPECT_EQ(ask("22 ff ff"), hex("7f 22 31"));
  EXPECT_EQ(ask("22 02 02"), hex("7f 22 31"));
  EXPECT_EQ(ask("22 02 22"), hex("7f 22 31"));
  EXPECT_EQ(ask("22 01 ff"), hex("7f 22 31"));
  EXPECT_EQ(ask("22 02 43"), hex("7f 22 31"));
}

TEST_F(ServerTest, ReadRequestsOfWrongLength) {
  for (const auto* request :
       {"22", "22 02", "22 02 40 02", "22 0240 0240 0240 0240 0240 0240 0240 0240 0240"}) {
    EXPECT_EQ(ask(request), hex("7f 22 13")) << request;
  }
  EXPECT_EQ(ask("22 0240 0240 0240 0240 0240 0240 0240 0240").size(), 1u + 8 * 6);
}

TEST_F(ServerTest, AnAnswerThatIsTooLong) {
  EXPECT_EQ(ask("22 0200 0201").size(), 127u);
  EXPECT_EQ(ask("22 0200 0201 0240"), hex("7f 22 14"));
  EXPECT_EQ(ask("22 0240", 7), hex("62 0240 29000000"));
  EXPECT_EQ(ask("22 0240", 6), hex("7f 22 14"));
  EXPECT_EQ(ask("22 0240", 4), hex("7f 22 14"));
}

TEST_F(ServerTest, ANonceThatFindsNoRoomIsNotIssued) {
  EXPECT_EQ(ask("22 0241", 18), hex("7f 22 14"));
  EXPECT_EQ(device_.nonces, 0u);
  EXPECT_EQ(ask("22 0241", 19).size(), 19u);
}

TEST_F(ServerTest, TellsTheStateOfTheAuthority) {
  EXPECT_EQ(ask("22 0242"), hex("62 0242 01 00 00000000 00000000 00000000 00000000"));
  for (int i = 0; i < 3; ++i) {
    ask(start_request({}));
  }
  now_ = now_ + hal::Time{1'500};
  // 10 s less 1.5 ms, rounded up: 9999 ms.
  EXPECT_EQ(ask("22 0242"), hex("62 0242 01 03 0f270000 00000000 03000000 00000000"));
}

TEST(Server, TellsThatItHasNoKey) {
  ModelDevice device(1);
  uds::Server<ModelDevice> server(device, kNode, authority::Key{});
  Bytes response(128);
  response.resize(server.handle(hex("22 0242"), {}, response));
  EXPECT_EQ(response.at(3), std::byte{0});
}

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
  EXPECT_EQ(to_bytes(device.life.blocks[1].bytes()), paper_block());
}

TEST(Endpoint, AnOversizedTransferIsRefusedCountedAndLogged) {
  ModelDevice device(2);
  Tester tester(device, kNode, kKey);
  const ModelLife life = device.life;
  EXPECT_EQ(tester.ask(counting(146)), std::nullopt);
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
