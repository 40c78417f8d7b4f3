// Commands under authority, as a client sends them: what is proven is done, all else changes
// nothing, is counted and leaves its line.
#include <gtest/gtest.h>

#include <functional>

#include "tests/protocol/services/served.hpp"

namespace protocol::testing {
namespace {

using storage::Event;

class AuthorityTest : public ServedTest {
 protected:
  Order load_order(const Bytes& block) {
    Order order = fresh_order();
    order.routine = 0x0202;
    order.arguments = hex("01") + block;
    return order;
  }

  /// That the request changes nothing, is counted, and leaves this line.
  void expect_refused(const Bytes& request, std::string_view answer, Event event,
                      std::uint32_t routine = 0x0201) {
    const ModelLife life = device_.life;
    const std::size_t lines = device_.lines.size();
    const std::uint32_t refused = server_->counts().refused;
    EXPECT_EQ(ask(request), hex(answer));
    EXPECT_EQ(device_.life, life);
    EXPECT_EQ(server_->counts().refused, refused + 1);
    ASSERT_EQ(device_.lines.size(), lines + 1);
    EXPECT_EQ(device_.lines.back().event, event);
    EXPECT_EQ(device_.lines.back().detail, routine);
  }
  /// A failure of any kind: a command whose nonce was used.
  void fail() { ask(start_request({})); }
};

TEST_F(AuthorityTest, OpensANewEpoch) {
  Order order = fresh_order();
  order.arguments = hex("01");
  const ModelLife before = device_.life;
  EXPECT_EQ(ask(start_request(order)), hex("71 01 02 01"));
  EXPECT_EQ(device_.life.records[0], before.records[0]);
  EXPECT_EQ(device_.life.records[1].epoch, before.records[1].epoch + 1);
  EXPECT_EQ(device_.life.records[1].lifetime_damage, before.records[1].lifetime_damage);
  ASSERT_EQ(device_.lines.size(), 1u);
  EXPECT_EQ(device_.lines[0].event, Event::epoch_opened);
  EXPECT_EQ(device_.lines[0].tendon, 1);
  EXPECT_EQ(device_.lines[0].epoch, before.records[1].epoch);
  EXPECT_EQ(device_.lines[0].detail, 0xc0ffee01u);
  EXPECT_EQ(server_->counts(), (uds::AuthorityCounts{.granted = 1}));
}

TEST_F(AuthorityTest, LoadsAParameterBlock) {
  const Bytes block = paper_block();
  const Order order = load_order(block);
  EXPECT_EQ(ask(start_request(order)), hex("71 01 02 02"));
  EXPECT_EQ(to_bytes(device_.life.blocks[1].bytes()), block);
  EXPECT_EQ(device_.last_sample_period_us, 1000u);
  ASSERT_EQ(device_.lines.size(), 1u);
  EXPECT_EQ(device_.lines[0].event, Event::parameters_loaded);
  // The CRC of the block is its last word.
  EXPECT_EQ(little_endian(device_.lines[0].detail), Bytes(block.end() - 4, block.end()));
}

TEST_F(AuthorityTest, TheLineComesBeforeTheDeed) {
  ask(start_request(fresh_order()));
  EXPECT_EQ(device_.lines_at_deed, 1u);
  ask(start_request(load_order(paper_block())));
  EXPECT_EQ(device_.lines_at_deed, 2u);
}

TEST_F(AuthorityTest, APositiveAnswerMayBeSuppressed) {
  const Order order = fresh_order();
  EXPECT_EQ(ask(start_request(order, 0x81)), Bytes{});
  EXPECT_EQ(server_->counts().granted, 1u);
  expect_refused(start_request(order, 0x81), "7f 31 24", Event::nonce_reused);
}

TEST_F(AuthorityTest, AReplayedCommand) {
  const Bytes request = start_request(fresh_order());
  EXPECT_EQ(ask(request), hex("71 01 02 01"));
  expect_refused(request, "7f 31 24", Event::nonce_reused);
}

TEST_F(AuthorityTest, AReplayedCommandWithAnotherNonceOpen) {
  const Bytes request = start_request(fresh_order());
  EXPECT_EQ(ask(request), hex("71 01 02 01"));
  fresh_order();
  expect_refused(request, "7f 31 35", Event::wrong_mac);
}

TEST_F(AuthorityTest, ACommandForAnOlderNonce) {
  const Bytes request = start_request(fresh_order());
  fresh_order();
  expect_refused(request, "7f 31 35", Event::wrong_mac);
}

TEST_F(AuthorityTest, ACommandForAnotherNode) {
  Order order = fresh_order();
  order.node = kNode + 1;
  expect_refused(start_request(order), "7f 31 35", Event::wrong_mac);
}

TEST_F(AuthorityTest, ACommandUnderAnotherKey) {
  Order order = fresh_order();
  order.key[15] ^= std::byte{1};
  expect_refused(start_request(order), "7f 31 35", Event::wrong_mac);
}

TEST_F(AuthorityTest, EveryFlippedBitOfTheCode) {
  for (std::size_t bit = 0; bit < 64; ++bit) {
    device_.lines.clear();
    restart();
    Bytes request = start_request(fresh_order());
    request[request.size() - 8 + bit / 8] ^= std::byte{1} << (bit % 8);
    expect_refused(request, "7f 31 35", Event::wrong_mac);
  }
}

TEST_F(AuthorityTest, EveryFlippedBitOfTheRequest) {
  const std::size_t bits = 8 * start_request(load_order(paper_block())).size();
  for (std::size_t bit = 0; bit < bits; ++bit) {
    // The suppress bit takes no part in what is done.
    if (bit == 15) {
      continue;
    }
    device_.lines.clear();
    restart();
    Bytes request = start_request(load_order(paper_block()));
    request[bit / 8] ^= std::byte{1} << (bit % 8);
    const ModelLife life = device_.life;
    const Bytes answer = ask(request);
    ASSERT_EQ(answer.at(0), std::byte{0x7f}) << bit;
    ASSERT_EQ(device_.life, life) << bit;
  }
}

TEST_F(AuthorityTest, AnExpiredNonce) {
  const Bytes request = start_request(fresh_order());
  now_ = now_ + hal::seconds(5);
  expect_refused(request, "7f 31 24", Event::nonce_expired);
}

TEST_F(AuthorityTest, ACounterThatIsNotThatOfTheNode) {
  for (const int difference : {-1, 1}) {
    Order order = fresh_order();
    order.counter += static_cast<std::uint32_t>(difference);
    expect_refused(start_request(order), "7f 31 22", Event::counter_rolled_back);
  }
  EXPECT_EQ(server_->gate().failures(), 0u);
  restart();
  EXPECT_EQ(server_->gate().failures(), 0u);
}

TEST_F(AuthorityTest, AStorageThatMovedOnSinceTheCounterWasRead) {
  const Bytes request = start_request(fresh_order());
  ++device_.life.counter;
  EXPECT_EQ(ask(request), hex("71 01 02 01"));

  // The counter read first, and longer ago than a nonce lives.
  const auto order_after = [this](hal::Time pause) {
    Order order;
    const Bytes counter = ask(hex("22 02 40"));
    order.counter = lifemodel::ByteReader(std::span(counter).last(4)).u32();
    ++device_.life.counter;
    now_ = now_ + pause;
    const Bytes nonce = ask(hex("22 02 41"));
    std::copy_n(nonce.begin() + 3, order.nonce.size(), order.nonce.begin());
    return start_request(order);
  };
  EXPECT_EQ(ask(order_after(hal::Time{4'999'999})), hex("71 01 02 01"));
  expect_refused(order_after(hal::seconds(5)), "7f 31 22", Event::counter_rolled_back);
}

TEST_F(AuthorityTest, AWrongLength) {
  expect_refused(hex("31 01 02"), "7f 31 13", Event::rejected, 0);
  const Bytes request = start_request(fresh_order());
  for (std::size_t size = 4; size <= request.size() + 1; ++size) {
    if (size == request.size()) {
      continue;
    }
    restart();
    Bytes other = request;
    other.resize(size);
    expect_refused(other, "7f 31 13", Event::rejected);
  }
}

TEST_F(AuthorityTest, AnUnknownRoutine) {
  for (const unsigned routine : {0x0000u, 0x0200u, 0x0204u, 0x0301u, 0xffffu}) {
    restart();
    Order order = fresh_order();
    order.routine = static_cast<std::uint16_t>(routine);
    expect_refused(start_request(order), "7f 31 31", Event::rejected, routine);
  }
}

TEST_F(AuthorityTest, AnotherSubFunction) {
  for (const unsigned sub_function : {0x00u, 0x02u, 0x03u, 0x7fu, 0x80u, 0x82u}) {
    restart();
    expect_refused(start_request(fresh_order(), static_cast<std::uint8_t>(sub_function)),
                   "7f 31 12", Event::rejected);
  }
}

TEST_F(AuthorityTest, ATendonThatIsNotThere) {
  for (const auto* tendon : {"02", "ff"}) {
    restart();
    Order order = fresh_order();
    order.arguments = hex(tendon);
    expect_refused(start_request(order), "7f 31 31", Event::rejected);
  }
}

/// The paper's block with a limit of the watch, which makes it one of version 2.
Bytes watched_block() {
  auto constants = lifemodel_test::paper_constants();
  constants.watch.minimum_tension_N = 1;
  return to_bytes(lifemodel::encode(lifemodel_test::parameters_of(constants)));
}

TEST_F(AuthorityTest, AParameterBlockOfVersion2InOneRequest) {
  const Bytes block = watched_block();
  ASSERT_EQ(block.size(), 128u);
  const Bytes request = start_request(load_order(block));
  EXPECT_EQ(request.size(), 145u);
  EXPECT_EQ(ask(request), hex("71 01 02 02"));
  EXPECT_EQ(to_bytes(device_.life.blocks[1].bytes()), block);
  EXPECT_EQ(device_.lines.back().event, Event::parameters_loaded);
}

TEST_F(AuthorityTest, ALengthThatNoParameterBlockHas) {
  for (const std::size_t size : {0u, 83u, 85u, 127u, 129u}) {
    restart();
    Bytes block = watched_block();
    block.resize(size);
    expect_refused(start_request(load_order(block)), "7f 31 13", Event::rejected, 0x0202);
  }
}

TEST_F(AuthorityTest, AParameterBlockWithTheLengthOfTheOtherVersion) {
  Bytes longer = paper_block();
  longer.resize(128);
  Bytes shorter = watched_block();
  shorter.resize(84);
  for (const Bytes& block : {longer, shorter}) {
    restart();
    expect_refused(start_request(load_order(block)), "7f 31 31", Event::parameters_refused,
                   lifemodel::ByteReader(std::span(block).last(4)).u32());
  }
  EXPECT_EQ(server_->gate().failures(), 0u);
}

TEST_F(AuthorityTest, AParameterBlockThatDoesNotHold) {
  Bytes block = paper_block();
  block[20] ^= std::byte{1};
  expect_refused(start_request(load_order(block)), "7f 31 31", Event::parameters_refused,
                 lifemodel::ByteReader(std::span(block).last(4)).u32());
  // The block does not hold.
  EXPECT_EQ(ask(hex("22 02 61")),
            hex("62 02 61 01 02 00 00") + Bytes(block.end() - 4, block.end()));
  EXPECT_EQ(server_->gate().failures(), 0u);
}

TEST_F(AuthorityTest, WithoutAKey) {
  restart(authority::Key{});
  Order order = fresh_order();
  order.key = {};
  expect_refused(start_request(order), "7f 31 33", Event::disabled);
}

TEST_F(AuthorityTest, TheThirdFailureLocks) {
  fail();
  fail();
  Bytes request = start_request(fresh_order());
  request.back() ^= std::byte{1};
  expect_refused(request, "7f 31 36", Event::wrong_mac);
  now_ = now_ + hal::Time{9'999'999};
  const Bytes honest = start_request(fresh_order());
  expect_refused(honest, "7f 31 37", Event::locked_out);
  now_ = now_ + hal::Time{1};
  EXPECT_EQ(ask(honest), hex("71 01 02 01"));
  EXPECT_EQ(server_->gate().failures(), 0u);
}

TEST_F(AuthorityTest, TheLockOutlivesARestart) {
  fail();
  fail();
  restart();
  EXPECT_EQ(server_->gate().failures(), 2u);
  EXPECT_FALSE(server_->gate().locked(now_));
  fail();
  now_ = hal::Time{};  // the clock begins anew
  restart();
  EXPECT_EQ(server_->gate().lock_left(now_), hal::seconds(10));
  expect_refused(start_request(fresh_order()), "7f 31 37", Event::locked_out);
  restart();
  EXPECT_EQ(server_->gate().lock_left(now_), hal::seconds(10));
}

TEST_F(AuthorityTest, ALogFullOfRefusalsDoesNotForgetFailures) {
  const auto wait = [this] { now_ = now_ + server_->gate().lock_left(now_); };
  for (int i = 0; i < 64; ++i) {
    fail();
    wait();
  }
  ASSERT_EQ(device_.lines.size(), 64u);
  EXPECT_EQ(ask(start_request(fresh_order())), hex("71 01 02 01"));
  ASSERT_EQ(device_.lines.size(), 65u);
  restart();
  EXPECT_EQ(server_->gate().failures(), 0u);

  // Nobody can know whether more came after the first failure: the longest lock there is.
  fail();
  restart();
  EXPECT_EQ(server_->gate().lock_left(now_), hal::seconds(640));
  wait();
  for (int i = 0; i < 5; ++i) {
    fail();
    wait();
  }
  restart();
  EXPECT_EQ(server_->gate().lock_left(now_), hal::seconds(640));
  EXPECT_EQ(device_.lines.size(), 66u);

  // A grant forgives them, and the next failure is not forgotten either.
  wait();
  EXPECT_EQ(ask(start_request(fresh_order())), hex("71 01 02 01"));
  restart();
  EXPECT_EQ(server_->gate().failures(), 0u);
  fail();
  restart();
  EXPECT_EQ(server_->gate().lock_left(now_), hal::seconds(640));
  EXPECT_EQ(device_.lines.size(), 68u);
}

TEST_F(AuthorityTest, ANonceDoesNotOutliveARestart) {
  const Bytes request = start_request(fresh_order());
  restart();
  expect_refused(request, "7f 31 24", Event::nonce_reused);
}

TEST_F(AuthorityTest, AFullLogAllowsNothing) {
  device_.log_capacity = 0;
  const ModelLife life = device_.life;
  EXPECT_EQ(ask(start_request(fresh_order())), hex("7f 31 22"));
  EXPECT_EQ(ask(start_request(load_order(paper_block()))), hex("7f 31 22"));
  EXPECT_EQ(device_.life, life);
  EXPECT_EQ(server_->counts().refused, 2u);
}

TEST_F(AuthorityTest, ALogThatFailsAllowsNothing) {
  device_.log_fault = hal::Error::failed;
  const ModelLife life = device_.life;
  EXPECT_EQ(ask(start_request(fresh_order())), hex("7f 31 72"));
  EXPECT_EQ(device_.life, life);
}

TEST_F(AuthorityTest, AChangeThatCannotBeWritten) {
  device_.deed_fault = hal::Error::failed;
  for (const Order& order : {fresh_order(), load_order(paper_block())}) {
    (void)order;
    device_.lines.clear();
    Order fresh = fresh_order();
    fresh.routine = order.routine;
    fresh.arguments = order.arguments;
    EXPECT_EQ(ask(start_request(fresh)), hex("7f 31 72"));
    ASSERT_EQ(device_.lines.size(), 2u);
    EXPECT_EQ(device_.lines[1].event, Event::not_done);
    EXPECT_EQ(device_.lines[1].detail, order.routine);
  }
  EXPECT_EQ(server_->counts(), (uds::AuthorityCounts{.refused = 2}));
}

TEST_F(AuthorityTest, LifetimeDamageIsNeverCleared) {
  const auto before = device_.life.records;
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(ask(start_request(fresh_order())), hex("71 01 02 01"));
    ASSERT_EQ(ask(start_request(load_order(paper_block()))), hex("71 01 02 02"));
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(device_.life.records[i].lifetime_damage, before[i].lifetime_damage);
  }
}

}  // namespace
}  // namespace protocol::testing
