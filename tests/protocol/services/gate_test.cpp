#include "firmware/protocol/authority/gate.hpp"

#include <gtest/gtest.h>

#include "tests/protocol/services/bytes.hpp"

namespace protocol::authority {
namespace {

using protocol::testing::Bytes;
using protocol::testing::hex;
using protocol::testing::hex_array;

const Key kKey = hex_array<Key>("000102030405060708090a0b0c0d0e0f");
constexpr Node kNode = 5;
constexpr std::uint32_t kCounter = 7;

const Nonce kNonce = hex_array<Nonce>("a0a1a2a3a4a5a6a7a8a9aaabacadaeaf");

// openssl mac -cipher AES-128-CBC -macopt hexkey:000102...0f CMAC, over the documented bytes
// 544c4131 05 0201 01 a0a1...af 44332211 03.
TEST(CommandCode, OverTheDocumentedBytes) {
  const Bytes arguments = hex("03");
  const Command command{.routine = 0x0201, .arguments = arguments, .storage_counter = 0x11223344};
  EXPECT_EQ(mac(kKey, 5, command, kNonce), hex_array<Mac>("e191de960723014c"));
}

TEST(CommandCode, CoversEverything) {
  const Bytes one = hex("03");
  const Bytes other = hex("04");
  const Bytes longer = hex("0300");
  const Command command{.routine = 0x0201, .arguments = one, .storage_counter = 1};
  const Mac code = mac(kKey, 5, command, kNonce);
  const auto changed = [&](auto change) {
    Command copy = command;
    change(copy);
    return mac(kKey, 5, copy, kNonce);
  };
  EXPECT_NE(changed([](Command& c) { c.routine = 0x0202; }), code);
  EXPECT_NE(changed([](Command& c) { c.routine = 0x0301; }), code);
  EXPECT_NE(changed([&](Command& c) { c.arguments = other; }), code);
  EXPECT_NE(changed([&](Command& c) { c.arguments = longer; }), code);
  EXPECT_NE(changed([&](Command& c) { c.transferred = one; }), code);
  EXPECT_NE(changed([](Command& c) { c.storage_counter = 0x01000001; }), code);
  EXPECT_NE(mac(kKey, 6, command, kNonce), code);
  Nonce nonce = kNonce;
  nonce[15] ^= std::byte{1};
  EXPECT_NE(mac(kKey, 5, command, nonce), code);
  Key key = kKey;
  key[0] ^= std::byte{0x80};
  EXPECT_NE(mac(key, 5, command, kNonce), code);
}

Nonce nonce_of(std::uint8_t n) {
  Nonce nonce{};
  nonce.fill(std::byte{n});
  return nonce;
}

class GateTest : public ::testing::Test {
 protected:
  void issue(std::uint8_t n, hal::Time now) {
    ASSERT_TRUE(gate_.issue(nonce_of(n), kCounter, now));
  }
  Mac code(std::uint8_t n) const { return mac(kKey, kNode, command_, nonce_of(n)); }
  Verdict check(std::uint8_t n, hal::Time now) {
    return gate_.check(command_, code(n), kCounter, now);
  }
  Verdict wrong(hal::Time now) { return gate_.check(command_, Mac{}, kCounter, now); }

  Bytes arguments_ = hex("00");
  Command command_{.routine = 0x0201, .arguments = arguments_, .storage_counter = kCounter};
  Gate gate_{kNode, kKey};
};

TEST_F(GateTest, GrantsWhatIsProvenWithAFreshNonce) {
  issue(1, hal::seconds(1));
  EXPECT_EQ(check(1, hal::seconds(2)), Verdict::granted);
  EXPECT_EQ(gate_.failures(), 0u);
}

TEST_F(GateTest, NothingWithoutANonce) {
  EXPECT_EQ(gate_.check(command_, mac(kKey, kNode, command_, Nonce{}), kCounter, {}),
            Verdict::nonce_used);
}

TEST_F(GateTest, ANonceServesOnce) {
  issue(1, {});
  EXPECT_EQ(check(1, {}), Verdict::granted);
  EXPECT_EQ(check(1, {}), Verdict::nonce_used);
}

TEST_F(GateTest, AFailureUsesTheNonceUp) {
  issue(1, {});
  EXPECT_EQ(wrong({}), Verdict::wrong_mac);
  EXPECT_EQ(check(1, {}), Verdict::nonce_used);
}

TEST_F(GateTest, AFreshNonceClosesTheOneBefore) {
  issue(1, {});
  issue(2, {});
  EXPECT_EQ(check(1, {}), Verdict::wrong_mac);
}

TEST_F(GateTest, ASourceThatRepeatsItselfOpensNothing) {
  issue(1, {});
  EXPECT_FALSE(gate_.issue(nonce_of(1), kCounter, {}));
  EXPECT_EQ(check(1, {}), Verdict::nonce_used);
  Gate fresh(kNode, kKey);
  EXPECT_FALSE(fresh.issue(Nonce{}, kCounter, {}));
}

TEST_F(GateTest, ANonceLivesForFiveSeconds) {
  issue(1, hal::seconds(10));
  EXPECT_EQ(check(1, hal::Time{14'999'999}), Verdict::granted);
  issue(2, hal::seconds(20));
  EXPECT_EQ(check(2, hal::seconds(25)), Verdict::nonce_expired);
}

TEST_F(GateTest, TheCounterHasToBeThatOfTheNode) {
  for (const std::uint32_t here : {kCounter - 1, kCounter + 1}) {
    Gate gate(kNode, kKey);
    ASSERT_TRUE(gate.issue(nonce_of(1), here, {}));
    EXPECT_EQ(gate.check(command_, code(1), here, {}), Verdict::wrong_counter);
    // Who holds the key guesses nothing.
    EXPECT_EQ(gate.failures(), 0u);
    EXPECT_EQ(gate.check(command_, code(1), here, {}), Verdict::nonce_used);
  }
}

TEST_F(GateTest, SavesMeanwhileDoNotRefuseACommand) {
  // Issued at 5, saved twice, and the counter read anywhere between.
  for (std::uint32_t issued = kCounter - 2; issued <= kCounter; ++issued) {
    Gate gate(kNode, kKey);
    ASSERT_TRUE(gate.issue(nonce_of(1), issued, {}));
    EXPECT_EQ(gate.check(command_, code(1), kCounter + 2, hal::seconds(4)), Verdict::granted);
  }
  // The counter read first, and saved twice before the nonce was issued.
  gate_.note_read(kCounter, hal::seconds(10));
  ASSERT_TRUE(gate_.issue(nonce_of(1), kCounter + 2, hal::Time{14'999'999}));
  EXPECT_EQ(gate_.check(command_, code(1), kCounter + 3, hal::seconds(16)), Verdict::granted);
}

TEST_F(GateTest, ACounterThatWasToldLongAgoProvesNothing) {
  gate_.note_read(kCounter, hal::seconds(10));
  ASSERT_TRUE(gate_.issue(nonce_of(1), kCounter + 1, hal::seconds(15)));
  EXPECT_EQ(gate_.check(command_, code(1), kCounter + 1, hal::seconds(15)), Verdict::wrong_counter);
  // Nor one that comes before what was read.
  gate_.note_read(kCounter + 1, hal::seconds(20));
  ASSERT_TRUE(gate_.issue(nonce_of(2), kCounter + 2, hal::seconds(20)));
  EXPECT_EQ(gate_.check(command_, code(2), kCounter + 2, hal::seconds(20)), Verdict::wrong_counter);
}

TEST_F(GateTest, EveryBitOfTheCodeCounts) {
  for (std::size_t bit = 0; bit < 64; ++bit) {
    Gate gate(kNode, kKey);
    ASSERT_TRUE(gate.issue(nonce_of(1), kCounter, {}));
    Mac flipped = code(1);
    flipped[bit / 8] ^= std::byte{1} << (bit % 8);
    EXPECT_EQ(gate.check(command_, flipped, kCounter, {}), Verdict::wrong_mac) << bit;
  }
}

TEST_F(GateTest, ACodeOfAnotherLengthIsWrong) {
  const Mac whole = code(1);
  for (std::size_t size = 0; size < kMacBytes; ++size) {
    Gate gate(kNode, kKey);
    ASSERT_TRUE(gate.issue(nonce_of(1), kCounter, {}));
    EXPECT_EQ(gate.check(command_, std::span(whole).first(size), kCounter, {}), Verdict::wrong_mac);
  }
}

TEST_F(GateTest, AnotherNodeIsNotMeant) {
  issue(1, {});
  const Mac for_other = mac(kKey, kNode + 1, command_, nonce_of(1));
  EXPECT_EQ(gate_.check(command_, for_other, kCounter, {}), Verdict::wrong_mac);
}

TEST_F(GateTest, WithoutAKeyNothingIsAllowed) {
  Gate gate(kNode, Key{});
  EXPECT_FALSE(gate.enabled());
  ASSERT_TRUE(gate.issue(nonce_of(1), kCounter, {}));
  EXPECT_EQ(gate.check(command_, mac(Key{}, kNode, command_, nonce_of(1)), kCounter, {}),
            Verdict::disabled);
  EXPECT_EQ(gate.failures(), 0u);
  for (std::size_t i = 0; i < 16; ++i) {
    Key key{};
    key[i] = std::byte{1};
    EXPECT_TRUE(Gate(kNode, key).enabled()) << i;
  }
}

TEST_F(GateTest, TheThirdFailureLocksForTenSeconds) {
  EXPECT_EQ(wrong({}), Verdict::nonce_used);
  EXPECT_EQ(wrong({}), Verdict::nonce_used);
  EXPECT_FALSE(gate_.locked({}));
  EXPECT_EQ(wrong({}), Verdict::nonce_used);
  EXPECT_TRUE(gate_.locked({}));
  EXPECT_EQ(gate_.lock_left({}), hal::seconds(10));

  const hal::Time last{9'999'999};
  issue(1, last);
  EXPECT_EQ(check(1, last), Verdict::locked_out);
  EXPECT_EQ(gate_.failures(), 3u);
  // The nonce was not used up by that.
  EXPECT_EQ(check(1, hal::seconds(10)), Verdict::granted);
  EXPECT_EQ(gate_.failures(), 0u);
  EXPECT_EQ(gate_.lock_left(hal::seconds(10)), hal::Time{});
}

TEST_F(GateTest, TheLockDoublesUpTo640Seconds) {
  hal::Time now{};
  EXPECT_EQ(wrong(now), Verdict::nonce_used);
  EXPECT_EQ(wrong(now), Verdict::nonce_used);
  for (const unsigned expected_s : {10u, 20u, 40u, 80u, 160u, 320u, 640u, 640u, 640u}) {
    EXPECT_EQ(wrong(now), Verdict::nonce_used);
    EXPECT_EQ(gate_.lock_left(now), hal::seconds(expected_s));
    now = now + gate_.lock_left(now);
  }
}

TEST_F(GateTest, FailuresOutliveARestart) {
  const hal::Time boot = hal::seconds(100);
  gate_.resume(2, boot);
  EXPECT_FALSE(gate_.locked(boot));
  gate_.resume(4, boot);
  EXPECT_EQ(gate_.lock_left(boot), hal::seconds(20));
  gate_.resume(0xffff'ffff, boot);
  EXPECT_EQ(gate_.lock_left(boot), hal::seconds(640));
  EXPECT_EQ(wrong(boot + hal::seconds(640)), Verdict::nonce_used);
  EXPECT_EQ(gate_.failures(), 0xffff'ffffu);
}

TEST(VerdictText, EachHasItsOwn) {
  EXPECT_STREQ(to_string(Verdict::disabled), "this node has no key, so nothing is allowed");
  EXPECT_STREQ(to_string(Verdict::nonce_expired), "the nonce is older than 5 s");
}

}  // namespace
}  // namespace protocol::authority
