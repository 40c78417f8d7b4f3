#include <gtest/gtest.h>

#include <algorithm>

#include "rig.hpp"
#include "tests/protocol/services/bytes.hpp"
#include "tests/protocol/services/requests.hpp"

namespace app {
namespace {

using protocol::testing::Bytes;
using protocol::testing::hex;
using protocol::testing::Order;
using protocol::testing::start_request;
using protocol::testing::operator+;

std::uint32_t word_at(const Bytes& bytes, std::size_t at) {
  return lifemodel::ByteReader(std::span(bytes).subspan(at)).u32();
}

/// A tester on the bus of a rig that runs meanwhile.
class Client {
 public:
  explicit Client(Rig<>& rig) : rig_(rig) {}

  /// Empty where no answer comes within ten seconds.
  Bytes ask(const Bytes& request) {
    link_.clear();
    EXPECT_EQ(link_.send(request), hal::Error::none);
    for (int i = 0; i < 10'000 && link_.received().empty(); ++i) {
      if (const auto frame = link_.next_frame(rig_.clock.now())) {
        EXPECT_EQ(rig_.tester.send(*frame), hal::Error::none);
      }
      rig_.run(1);
      while (const auto frame = rig_.tester.receive()) {
        link_.on_frame(*frame, rig_.clock.now());
      }
    }
    return protocol::testing::to_bytes(link_.received());
  }

 private:
  Rig<>& rig_;
  protocol::isotp::Link<200> link_{protocol::isotp::Address::to_node(kNode)};
};

/// An order that the node will grant: with its counter and a fresh nonce.
Order order_for(Client& client, std::uint16_t routine, const Bytes& arguments) {
  Order order{.routine = routine, .arguments = arguments};
  const Bytes nonce = client.ask(hex("22 0241"));
  std::copy_n(nonce.begin() + 3, order.nonce.size(), order.nonce.begin());
  order.counter = word_at(client.ask(hex("22 0240")), 3);
  return order;
}

class Services : public ::testing::Test {
 protected:
  Services() {
    static_assert(protocol::testing::kNode == kNode);
    rig.config.key = protocol::testing::kKey;
    rig.start();
    rig.run(1'000);
  }

  Rig<> rig;
  Client client{rig};
};

TEST_F(Services, TheLifeRecordIsThatOfTheMoment) {
  const Bytes answer = client.ask(hex("22 0200"));
  ASSERT_EQ(answer.size(), 3u + protocol::uds::kLifeBytes);
  EXPECT_EQ(Bytes(answer.begin(), answer.begin() + 3), hex("62 0200"));
  EXPECT_GT(word_at(answer, 3 + 8), 0u);
  EXPECT_LE(word_at(answer, 3 + 8), rig.app->lives().damage_ppb(0));
  EXPECT_EQ(word_at(answer, 3 + 56), configuration_of(*rig.models[0]));
}

TEST_F(Services, ANewEpochBeginsAtNothingAndTheLifetimeStays) {
  const Order order = order_for(client, 0x0201, hex("00"));
  const lifemodel::Damage lifetime = rig.app->lives().records()[0].lifetime_damage;
  EXPECT_EQ(client.ask(start_request(order)), hex("71 01 0201"));
  EXPECT_EQ(rig.app->lives().records()[0].epoch, 1);
  EXPECT_GE(rig.app->lives().records()[0].lifetime_damage, lifetime);
  EXPECT_LT(rig.app->lives().damage(0), lifetime);
  EXPECT_EQ(rig.store.load(0)->epoch, 1);
  ASSERT_TRUE(rig.store.log(0).has_value());
  EXPECT_EQ(rig.store.log(0)->event, storage::Event::epoch_opened);

  // The same order again: its nonce is used.
  EXPECT_EQ(client.ask(start_request(order))[0], std::byte{0x7f});
  EXPECT_EQ(rig.app->lives().records()[0].epoch, 1);
}

TEST_F(Services, ANewWireHasNoneOfTheFlagsOfTheOld) {
  using lifemodel::Flag;
  // All that there are: the ultimate tension is 177.4 N.
  rig.run(40, 20, 180);
  rig.run(40, -30, 20);
  rig.app->isr_missed(3);
  rig.app->input_flags(0).raise(Flag::saturated);
  for (int i = 0; i < 200; ++i) {  // nobody settles
    rig.sensor.give(0, lifemodel::pack::tension(i % 2 == 0 ? 20 : 60, 177.4));
    rig.app->isr_sample();
  }
  rig.run(500);
  for (const Flag flag :
       {Flag::overload, Flag::negative_tension, Flag::gap, Flag::saturated, Flag::overrun}) {
    ASSERT_TRUE(rig.app->lives().flags().has(flag)) << static_cast<unsigned>(flag);
  }
  ASSERT_EQ(rig.app->lives().records()[0].history.above_90, 2u);

  EXPECT_EQ(client.ask(start_request(order_for(client, 0x0201, hex("00")))), hex("71 01 0201"));
  EXPECT_EQ(rig.store.load(0)->flags, 0);
  EXPECT_EQ(rig.store.load(0)->history, storage::WireHistory{});
  rig.run(2'000);
  EXPECT_TRUE(rig.app->lives().flags().none()) << rig.app->lives().flags().bits();
  // It has swung between 10 and 60 N.
  storage::WireHistory of_the_new;
  of_the_new.peak = static_cast<std::uint32_t>(lifemodel::pack::tension(60, 177.4).raw());
  of_the_new.operated_s = 2;
  EXPECT_EQ(rig.app->lives().records()[0].history, of_the_new);
  const protocol::LifeStatus status = rig.sent<protocol::LifeStatus>().back();
  EXPECT_EQ(status.quality, protocol::Quality::measured);
  EXPECT_FALSE(status.gap || status.saturated || status.overrun);
  EXPECT_EQ(rig.app->stop(), hal::Error::none);
  EXPECT_EQ(rig.store.load(0)->flags, 0);

  // Its own it has, those of the old wire among them.
  rig.app->isr_missed(1);
  rig.run(200);
  EXPECT_EQ(rig.app->lives().flags().bits(), static_cast<std::uint32_t>(Flag::gap));
  rig.run(40, 20, 180);
  rig.run(200);
  EXPECT_TRUE(rig.app->lives().flags().has(Flag::overload));
}

TEST_F(Services, AFlagThatComesWithTheNextSampleIsThatOfTheNewWire) {
  EXPECT_EQ(client.ask(start_request(order_for(client, 0x0201, hex("00")))), hex("71 01 0201"));
  rig.app->isr_missed(1);
  rig.run(200);
  EXPECT_EQ(rig.app->lives().flags().bits(), static_cast<std::uint32_t>(lifemodel::Flag::gap));
}

TEST_F(Services, AWrongCodeChangesNothingAndIsCounted) {
  Order order = order_for(client, 0x0201, hex("00"));
  order.node = kNode + 1;
  const std::uint16_t refused = rig.app->node_state().refused;
  EXPECT_EQ(client.ask(start_request(order))[0], std::byte{0x7f});
  rig.run(10);
  EXPECT_EQ(rig.app->lives().records()[0].epoch, 0);
  EXPECT_EQ(rig.app->node_state().refused, refused + 1);
}

TEST_F(Services, FailuresInARowAreToldOnTheBus) {
  for (int i = 0; i < 3; ++i) {
    Order order = order_for(client, 0x0201, hex("00"));
    order.node = kNode + 1;
    client.ask(start_request(order));
  }
  rig.run(500);
  const auto reported = rig.sent<protocol::Emergency>();
  EXPECT_TRUE(std::any_of(reported.begin(), reported.end(), [](const auto& emergency) {
    return emergency.code == protocol::EmergencyCode::authority;
  }));
}

TEST_F(Services, ALoadedBlockCountsFromTheNextStart) {
  const lifemodel::Parameters stronger = paper_parameters(3e5);
  const Bytes block = protocol::testing::to_bytes(lifemodel::encode(stronger));
  const std::uint32_t counter = rig.store.sequence();
  EXPECT_EQ(client.ask(start_request(order_for(client, 0x0202, hex("00") + block))),
            hex("71 01 0202"));
  EXPECT_EQ(rig.app->lives().records()[0].configuration, configuration_of(*rig.models[0]));
  EXPECT_GT(rig.store.sequence(), counter);
  rig.start();
  rig.run(10);
  EXPECT_EQ(rig.app->lives().records()[0].configuration, configuration_of({stronger, {}}));
}

TEST_F(Services, ABlockWithLimitsIsLoadedByTheSameRequest) {
  lifemodel::Parameters watched = paper_parameters();
  watched.watch.minimum = lifemodel::pack::tension(1, 177.4);
  const Bytes block = protocol::testing::to_bytes(lifemodel::encode(watched));
  ASSERT_EQ(block.size(), 128u);
  EXPECT_EQ(client.ask(start_request(order_for(client, 0x0202, hex("00") + block))),
            hex("71 01 0202"));
  rig.start();
  rig.run(10);
  EXPECT_EQ(rig.app->lives().records()[0].configuration, configuration_of({watched, {}}));
}

/// The same model with a load that does less: an endurance limit of a sixteenth of the ultimate
/// tension, and a correction that acts on output tension alone.
lifemodel::ExtendedParameters limited() {
  lifemodel::ExtendedParameters model{paper_parameters(), {}};
  using lifemodel::extension::Effect;
  model.extension.add(Effect::endurance_limit);
  model.extension.endurance_limit = {lifemodel::extension::kOne, -(4 << 26)};
  model.extension.add(Effect::empirical);
  model.extension.empirical.knots = 16;
  for (std::int32_t i = 0; i < 16; ++i) {
    model.extension.empirical.knot[static_cast<std::size_t>(i)] = {i << 20, i, -i};
  }
  return model;
}

/// Over ISO-TP, in parts of 126 bytes.
void transfer(Client& client, const Bytes& block) {
  const Bytes size{static_cast<std::byte>(block.size() >> 8), static_cast<std::byte>(block.size())};
  ASSERT_EQ(client.ask(hex("34 00 21 00") + size), hex("74 20 0091"));
  for (std::size_t at = 0, part = 1; at < block.size(); at += 126, ++part) {
    const auto end = std::min(at + 126, block.size());
    const Bytes bytes(block.begin() + static_cast<std::ptrdiff_t>(at),
                      block.begin() + static_cast<std::ptrdiff_t>(end));
    const auto number = static_cast<std::byte>(part);
    ASSERT_EQ(client.ask(Bytes{std::byte{0x36}, number} + bytes), (Bytes{std::byte{0x76}, number}));
  }
  ASSERT_EQ(client.ask(hex("37")), hex("77"));
}

TEST_F(Services, AnExtendedBlockIsTransferredAndCountsFromTheNextStart) {
  rig.evaluates = {{{true, lifemodel::extension::Input::motor_current, {}}}};
  rig.start();
  const lifemodel::ExtendedBlock extended(limited());
  const Bytes block = protocol::testing::to_bytes(extended.bytes());
  transfer(client, block);
  Order order = order_for(client, 0x0203, hex("00"));
  order.transferred = block;
  EXPECT_EQ(client.ask(start_request(order)), hex("71 01 0203"));
  EXPECT_EQ(rig.store.load_parameters(0), extended);
  EXPECT_EQ(rig.app->lives().records()[0].configuration, configuration_of(*rig.models[0]));
  EXPECT_EQ(client.ask(hex("22 0260")), hex("62 0260 01 00 00 00 00000000"));
  rig.start();
  rig.run(10);
  EXPECT_EQ(rig.app->lives().records()[0].configuration, extended.crc());
  EXPECT_EQ(client.ask(hex("22 0260")), hex("62 0260 02 00 00 00 00000000"));
}

TEST_F(Services, ABlockThatTheBoardCannotEvaluateIsRefusedWithTheReasonAndCountingGoesOn) {
  rig.evaluates = {{{true, lifemodel::extension::Input::motor_current, {.velocity = true}}}};
  rig.start();
  lifemodel::ExtendedParameters model = limited();
  model.extension.add(lifemodel::extension::Effect::torque_ripple);
  model.extension.torque_ripple.harmonic = 1 << 16;
  const Bytes block = protocol::testing::to_bytes(lifemodel::ExtendedBlock(model).bytes());
  const Bytes crc(block.end() - 4, block.end());
  transfer(client, block);
  Order order = order_for(client, 0x0203, hex("00"));
  order.transferred = block;
  const std::uint32_t before_ppb = rig.app->lives().damage_ppb(0);
  EXPECT_EQ(client.ask(start_request(order)), hex("7f 31 31"));
  // Effect 12 needs covariate 2, the angle of the rotor.
  EXPECT_EQ(client.ask(hex("22 0260")), hex("62 0260 01 05 0c 02") + crc);
  EXPECT_FALSE(rig.store.load_parameters(0));
  ASSERT_TRUE(rig.store.log(0).has_value());
  EXPECT_EQ(rig.store.log(0)->event, storage::Event::parameters_refused);
  rig.run(500);
  const auto reported = rig.sent<protocol::Emergency>();
  ASSERT_FALSE(reported.empty());
  EXPECT_EQ(reported.back().code, protocol::EmergencyCode::parameters);
  EXPECT_GT(rig.app->lives().damage_ppb(0), before_ppb);
  EXPECT_EQ(rig.app->lives().records()[0].configuration, configuration_of(*rig.models[0]));

  // One that it can count with ends the emergency.
  const lifemodel::ExtendedBlock good(limited());
  transfer(client, protocol::testing::to_bytes(good.bytes()));
  order = order_for(client, 0x0203, hex("00"));
  order.transferred = protocol::testing::to_bytes(good.bytes());
  EXPECT_EQ(client.ask(start_request(order)), hex("71 01 0203"));
  rig.run(500);
  EXPECT_EQ(rig.sent<protocol::Emergency>().back().code, protocol::EmergencyCode::none);
}

TEST(ServicesAtWork, AnOrderIsInTimeWhileTheDamageGrows) {
  Rig rig(1.53e9);
  rig.config.key = protocol::testing::kKey;
  rig.start();
  rig.run(20'000);
  Client client(rig);
  for (int epoch = 1; epoch < 4; ++epoch) {
    EXPECT_EQ(client.ask(start_request(order_for(client, 0x0201, hex("00")))), hex("71 01 0201"));
    EXPECT_EQ(rig.app->lives().records()[0].epoch, epoch);
    rig.run(3'000);
  }
}

// After a start the damage is saved every second while there is credit.
TEST(ServicesAtWork, NoSaveRefusesAnHonestOrder) {
  for (std::uint32_t phase = 0; phase < 120; ++phase) {
    Rig rig;
    rig.config.key = protocol::testing::kKey;
    rig.start();
    rig.run(500 + 15 * phase);
    Client client(rig);
    Order order{.routine = 0x0201, .arguments = hex("00")};
    const auto read_counter = [&] { order.counter = word_at(client.ask(hex("22 0240")), 3); };
    if (phase % 2 == 0) {
      read_counter();
    }
    const Bytes nonce = client.ask(hex("22 0241"));
    std::copy_n(nonce.begin() + 3, order.nonce.size(), order.nonce.begin());
    if (phase % 2 != 0) {
      read_counter();
    }
    rig.run(50);  // the client makes its code
    ASSERT_EQ(client.ask(start_request(order)), hex("71 01 0201")) << phase;
  }
}

TEST_F(Services, AnEpochThatCannotBeSavedIsNotOpened) {
  const Order order = order_for(client, 0x0201, hex("00"));
  rig.store.faults.during(rig.clock.now(), rig.clock.now() + hal::seconds(5), hal::Error::failed);
  EXPECT_EQ(client.ask(start_request(order))[0], std::byte{0x7f});
  EXPECT_EQ(rig.app->lives().records()[0].epoch, 0);
}

}  // namespace
}  // namespace app
