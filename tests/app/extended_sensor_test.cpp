#include "firmware/app/extended_sensor.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "firmware/app/app.hpp"
#include "hal/fake/can_port.hpp"
#include "hal/fake/clock.hpp"
#include "hal/fake/devices.hpp"
#include "lifemodel/pack/pack.hpp"
#include "ram_store.hpp"
#include "wire.hpp"

namespace app {
namespace {

using lifemodel::extension::DriveSample;
using lifemodel::extension::Effect;
using lifemodel::pack::from_double;
using lifemodel::pack::to_double;

DriveSample amperes(double current_A, double velocity_m_s = 0.1) {
  DriveSample sample;
  sample.current = from_double<lifemodel::MotorCurrent>(current_A);
  sample.at.velocity = from_double<lifemodel::Velocity>(velocity_m_s);
  return sample;
}

/// An offset of 0.5 A and a lag of five periods in the current.
lifemodel::ExtendedParameters extended() {
  lifemodel::ExtendedParameters model{paper_parameters(), {}};
  model.extension.current_offset.offset = 1 << 23;
  model.extension.add(Effect::current_offset);
  model.extension.input_lag.periods = 5 << 16;
  model.extension.add(Effect::input_lag);
  return model;
}

class ExtendedSensorTest : public testing::Test {
 protected:
  using Raw = hal::fake::Sensor<DriveSample>;

  double read_N(double current_A) {
    raw.give(0, amperes(current_A));
    return 177.4 * to_double((*sensor.isr_read(0)).sample);
  }

  hal::fake::Clock clock;
  Raw raw{clock};
  ExtendedSensor<Raw, 1>::Models models{extended()};
  ExtendedSensor<Raw, 1> sensor{raw, models};
};

TEST_F(ExtendedSensorTest, GivesTheTensionOfTheExtendedModel) {
  // 20.592 N/A: 1.5 A, then a step of 0.1 A that came five periods late.
  EXPECT_NEAR(read_N(2), 30.888, 1e-5);
  EXPECT_NEAR(read_N(2.1), 30.888 + 6 * 2.0592, 1e-4);
}

TEST_F(ExtendedSensorTest, HandsTheVelocityOn) {
  raw.give(0, amperes(2, -0.25));
  EXPECT_EQ((*sensor.isr_read(0)).velocity, from_double<Velocity>(-0.25));
}

TEST_F(ExtendedSensorTest, AMissingSampleLeavesNoRate) {
  EXPECT_NEAR(read_N(2), 30.888, 1e-5);
  EXPECT_EQ(sensor.isr_read(0).error(), hal::Error::missing);
  EXPECT_NEAR(read_N(2.1), 30.888 + 2.0592, 1e-5);
  sensor.isr_missed();
  EXPECT_NEAR(read_N(2), 30.888, 1e-5);
}

TEST_F(ExtendedSensorTest, TellsWhatWasHeld) {
  EXPECT_TRUE(sensor.isr_flags(0).none());
  (void)read_N(127.9);
  EXPECT_TRUE(sensor.isr_flags(0).has(lifemodel::Flag::saturated));
}

TEST(ExtendedSensorOfCurrent, EvaluatesWhatNeedsNothingBesides) {
  hal::fake::Clock clock;
  hal::fake::Sensor<lifemodel::MotorCurrent> raw{clock};
  const ExtendedModels<1> models{extended()};
  ExtendedSensor<decltype(raw), 1> sensor{raw, models};
  raw.give(0, amperes(2).current);
  EXPECT_NEAR(177.4 * to_double((*sensor.isr_read(0)).sample), 30.888, 1e-5);
  raw.give(0, amperes(2.1).current);
  EXPECT_NEAR(177.4 * to_double((*sensor.isr_read(0)).sample), 30.888 + 6 * 2.0592, 1e-4);
}

/// An application over an extended sensor whose model has wear.
class ExtendedAppTest : public testing::Test {
 protected:
  using Raw = hal::fake::Sensor<lifemodel::extension::SheathSample>;
  using Sensor = ExtendedSensor<Raw, 1>;
  using Devices =
      app::Devices<hal::fake::CanPort, Sensor, hal::fake::Clock, RamStore, hal::fake::DigitalOut,
                   hal::fake::DigitalOut, hal::fake::DigitalOut, hal::fake::DigitalIn,
                   hal::fake::Watchdog, hal::fake::Entropy, hal::NoHold>;

  static lifemodel::ExtendedParameters worn() {
    lifemodel::ExtendedParameters model{paper_parameters(), {}};
    // mu (1 + n/1000)
    model.extension.friction_wear = {0, 0, lifemodel::extension::kOne, 0};
    model.extension.add(Effect::friction_wear);
    return model;
  }

  double start_N(const storage::LifeRecord* record) {
    if (record != nullptr) {
      EXPECT_EQ(store.save(std::array{*record}), hal::Error::none);
    }
    App<1, Devices> app(Devices{can, sensor, clock, store, drive_enable, brake, light, stop,
                                watchdog, entropy, hold},
                        Config{}, starting_models<1>(store, {models[0]}, evaluates));
    app.start();
    raw.give(0, {lifemodel::pack::tension(49, 177.4), models[0].nominal.bend, amperes(0).at});
    return 177.4 * to_double((*sensor.isr_read(0)).sample);
  }

  hal::fake::Clock clock;
  Raw raw{clock};
  Sensor::Models models{worn()};
  Sensor sensor{raw, models};
  hal::fake::CanBus bus{clock};
  hal::fake::CanPort can{bus};
  RamStore store{clock};
  hal::fake::DigitalOut drive_enable{clock}, brake{clock}, light{clock};
  hal::fake::DigitalIn stop{clock};
  hal::fake::Watchdog watchdog{clock, hal::milliseconds(500)};
  hal::fake::Entropy entropy{clock, 1};
  hal::NoHold hold;
  std::array<Evaluates, 1> evaluates{
      {{true, lifemodel::extension::Input::output_tension, {.velocity = true}}}};
};

TEST_F(ExtendedAppTest, ANewSheathHasSeenNoCycles) {
  // 49 exp(0.128 * 4.712)
  EXPECT_NEAR(start_N(nullptr), 89.564, 1e-2);
}

TEST_F(ExtendedAppTest, WearGoesOnAfterARestart) {
  storage::LifeRecord record;
  record.epoch_cycles = 500;
  // 49 exp(1.5 * 0.128 * 4.712)
  EXPECT_NEAR(start_N(&record), 121.09, 2e-2);
}

}  // namespace
}  // namespace app
