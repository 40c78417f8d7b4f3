#include "firmware/app/models.hpp"

#include <gtest/gtest.h>

#include "rig.hpp"

namespace app {
namespace {

using lifemodel::extension::Effect;
using lifemodel::extension::Input;
using lifemodel::extension::Unmet;

lifemodel::ExtendedParameters nominal(double ipl_scale = 1.53e5) {
  return {paper_parameters(ipl_scale), {}};
}

/// A droop of the torque constant, which needs the temperature of the winding.
lifemodel::ExtendedParameters drooping() {
  lifemodel::ExtendedParameters model = nominal();
  model.extension.add(Effect::torque_gain);
  model.extension.torque_gain.droop = 1 << 20;
  return model;
}

lifemodel::ExtendedBlock block_of(const lifemodel::ExtendedParameters& model) {
  return lifemodel::ExtendedBlock(model);
}

constexpr Evaluates kCurrent{true, Input::motor_current, {}};
constexpr Evaluates kWarm{true, Input::motor_current, {.winding = true}};

class StartingModelsTest : public ::testing::Test {
 protected:
  StartingModels<1> start(const ConfiguredModels<1>& configured, const Evaluates& evaluates = {}) {
    return starting_models<1>(store, configured, {evaluates});
  }

  hal::fake::Clock clock;
  RamStore store{clock};
};

TEST_F(StartingModelsTest, TheLoadedBlockWinsOverTheConfiguredOne) {
  ASSERT_EQ(store.save_parameters(1, block_of(nominal(3e5))), hal::Error::none);
  const auto set = starting_models<2>(store, {nominal(1e5), nominal(2e5)});
  EXPECT_EQ(set.states[0].source, ParameterSource::configured);
  EXPECT_EQ(set.states[0].configuration, block_of(nominal(1e5)).crc());
  EXPECT_EQ(set.states[1].source, ParameterSource::loaded);
  EXPECT_EQ(set.states[1].configuration, block_of(nominal(3e5)).crc());
  EXPECT_EQ(set.states[1].refusal, ParameterRefusal{});
}

TEST_F(StartingModelsTest, AnExtensionIsLoadedWithItsBlock) {
  ASSERT_EQ(store.save_parameters(0, block_of(drooping())), hal::Error::none);
  const auto set = start({nominal(1e5)}, kWarm);
  EXPECT_TRUE(set.models[0].extension.has(Effect::torque_gain));
  EXPECT_EQ(set.models[0].extension.torque_gain.droop, 1 << 20);
  EXPECT_EQ(set.states[0].configuration, block_of(drooping()).crc());
  EXPECT_NE(set.states[0].configuration, block_of(nominal()).crc());
}

TEST_F(StartingModelsTest, WhatIsNotMeasuredLeavesTheOneBeforeAndTellsWhy) {
  ASSERT_EQ(store.save_parameters(0, block_of(drooping())), hal::Error::none);
  const auto set = start({nominal(1e5)}, kCurrent);
  EXPECT_EQ(set.states[0].source, ParameterSource::configured);
  EXPECT_EQ(set.states[0].configuration, block_of(nominal(1e5)).crc());
  EXPECT_EQ(set.models[0].extension.effects, 0u);
  // Effect 11 needs covariate 4.
  EXPECT_EQ(set.states[0].refusal,
            (ParameterRefusal{ParameterFault::not_measured, 11, 4, block_of(drooping()).crc()}));
}

TEST_F(StartingModelsTest, ABoardWithoutExtensionsRefusesThemAll) {
  const auto set = start({drooping()});
  EXPECT_FALSE(set.has(0));
  EXPECT_EQ(set.states[0].refusal.fault, ParameterFault::no_extensions);
  EXPECT_EQ(set.states[0].configuration, 0u);
}

TEST_F(StartingModelsTest, ABlockThatDoesNotHoldLeavesTheOneBefore) {
  const auto whole = block_of(drooping());
  for (const std::size_t at : {20u, 90u}) {
    std::vector<std::byte> bytes(whole.bytes().begin(), whole.bytes().end());
    bytes[at] ^= std::byte{1};
    ASSERT_EQ(store.save_parameters(0, lifemodel::ExtendedBlock(bytes)), hal::Error::none);
    const auto set = start({nominal(1e5)}, kWarm);
    EXPECT_EQ(set.states[0].source, ParameterSource::configured);
    EXPECT_EQ(set.states[0].refusal.fault,
              at == 20 ? ParameterFault::block : ParameterFault::extension);
    EXPECT_EQ(set.states[0].refusal.crc, whole.crc());
  }
}

TEST_F(StartingModelsTest, ATornBlockLeavesTheOneThatWasLoadedBefore) {
  ASSERT_EQ(store.save_parameters(0, block_of(nominal(3e5))), hal::Error::none);
  store.torn = true;
  const auto set = start({nominal(1e5)});
  EXPECT_EQ(set.states[0].source, ParameterSource::loaded);
  EXPECT_EQ(set.states[0].configuration, block_of(nominal(3e5)).crc());
  EXPECT_EQ(set.states[0].refusal, ParameterRefusal{ParameterFault::torn});
}

TEST_F(StartingModelsTest, ARefusalHasOneLineForEachBlock) {
  ParameterState state;
  log_refusal(store, 0, state, 7);
  EXPECT_FALSE(store.log(0));
  state.refusal = {ParameterFault::not_measured, 11, 4, 0xabcd};
  for (int start = 0; start < 3; ++start) {
    log_refusal(store, 0, state, 7);
  }
  ASSERT_TRUE(store.log(0));
  EXPECT_EQ(store.log(0)->event, storage::Event::parameters_refused);
  EXPECT_EQ(store.log(0)->detail, 0xabcdu);
  EXPECT_EQ(store.log(0)->epoch, 7);
  EXPECT_FALSE(store.log(1));
  log_refusal(store, 1, state, 7);
  EXPECT_TRUE(store.log(1));
  // Others were loaded meanwhile, and these came back.
  ASSERT_EQ(store.append({.event = storage::Event::parameters_loaded}), hal::Error::none);
  log_refusal(store, 0, state, 7);
  log_refusal(store, 0, state, 7);
  EXPECT_TRUE(store.log(3));
  EXPECT_FALSE(store.log(4));
}

/// A tendon that counts with what came before is told on the bus, and goes on.
TEST(RefusedParameters, AreToldOnTheBusAndCountingGoesOn) {
  for (const bool torn : {false, true}) {
    Rig rig;
    rig.store.torn = torn;
    if (!torn) {
      ASSERT_EQ(rig.store.save_parameters(0, block_of(drooping())), hal::Error::none);
    }
    rig.start();
    rig.run(2'000);
    EXPECT_GT(rig.app->lives().damage_ppb(0), 0u);
    EXPECT_EQ(rig.app->lives().records()[0].configuration, block_of(nominal()).crc());
    const auto emergencies = rig.sent<protocol::Emergency>();
    ASSERT_FALSE(emergencies.empty());
    EXPECT_EQ(emergencies[0].code, protocol::EmergencyCode::parameters);
    EXPECT_EQ(rig.sent<protocol::LifeStatus>().back().state, protocol::LifeState::normal);
    ASSERT_TRUE(rig.store.log(0));
    EXPECT_EQ(rig.store.log(0)->event, storage::Event::parameters_refused);
    EXPECT_EQ(rig.store.log(0)->detail, torn ? 0u : block_of(drooping()).crc());
  }
}

}  // namespace
}  // namespace app
