#include "firmware/boards/linux/surroundings.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "hal/linux/device_error.hpp"
#include "tests/io/support.hpp"

namespace boards::linux_controller {
namespace {

namespace fs = std::filesystem;
using host_sim::test::TemporaryFolder;
using host_sim::test::write_text;

hal::CanFrame frame_of(std::uint32_t id, std::initializer_list<unsigned> bytes) {
  hal::CanFrame frame;
  frame.id = id;
  for (const unsigned byte : bytes) {
    frame.data[frame.length++] = static_cast<std::byte>(byte);
  }
  return frame;
}

constexpr BusQuantity kTemperature{.id = 0x1a0,
                                   .start_bit = 8,
                                   .bits = 16,
                                   .is_signed = true,
                                   .factor = 0.25,
                                   .zero = 20,
                                   .timeout_ms = 500};

TEST(BusQuantity, LiesInAFrameLittleEndian) {
  // 0x0102 = 258; 0xfffc = -4.
  EXPECT_EQ(value_in(kTemperature, frame_of(0x1a0, {0xff, 0x02, 0x01})), 258 * 0.25 + 20);
  EXPECT_EQ(value_in(kTemperature, frame_of(0x1a0, {0, 0xfc, 0xff, 0x77})), 19);
  BusQuantity bits{.id = 5, .start_bit = 3, .bits = 4, .timeout_ms = 1};
  EXPECT_EQ(value_in(bits, frame_of(5, {0x7f})), 15);
  bits.is_signed = true;
  EXPECT_EQ(value_in(bits, frame_of(5, {0x7f})), -1);
  const BusQuantity whole{.id = 5, .start_bit = 0, .bits = 64, .is_signed = true, .timeout_ms = 1};
  EXPECT_EQ(value_in(whole, frame_of(5, {0xfe, 255, 255, 255, 255, 255, 255, 255})), -2);
}

TEST(BusQuantity, IsNotInOtherOrShorterFrames) {
  EXPECT_FALSE(value_in(kTemperature, frame_of(0x1a1, {0, 1, 2})));
  EXPECT_FALSE(value_in(kTemperature, frame_of(0x1a0, {0, 1})));
  hal::CanFrame extended = frame_of(0x1a0, {0, 1, 2});
  extended.extended = true;
  EXPECT_FALSE(value_in(kTemperature, extended));
}

class SurroundingsTest : public testing::Test {
 protected:
  SurroundingsTest() {
    fs::create_directories(device_);
    put("name", "encoder");
    put("in_anglvel0_raw", "-50");
    put("in_anglvel0_scale", "2");
    put("in_temp1_raw", "84");
    put("in_temp1_scale", "250");
    put("in_temp1_offset", "-4");
    config_.can.interface = "can0";
    TendonConfig tendon;
    tendon.covariates[0] = IioQuantity{"encoder", "in_anglvel0", 0.0025};
    tendon.covariates[2] = kTemperature;
    tendon.covariates[3] = IioQuantity{"encoder", "in_temp1", 1e-3};
    config_.tendons = {tendon};
  }
  void put(const char* attribute, std::string_view text) { write_text(device_ / attribute, text); }

  TemporaryFolder folder_;
  fs::path device_ = folder_ / "bus/iio/devices/iio:device0";
  Config config_;
};

TEST_F(SurroundingsTest, ComeFromChannelsAndFromTheBus) {
  Surroundings surroundings(config_, folder_ / ".");
  const hal::Time now = hal::seconds(100);
  EXPECT_EQ(surroundings.isr_read(0, now).error(), hal::Error::missing) << "no frame has come";
  surroundings.take(frame_of(0x1a0, {0, 0xfc, 0xff}), now);
  EXPECT_EQ(surroundings.isr_read(0, now).error(), hal::Error::missing) << "no winding was read";
  surroundings.poll(now);
  const auto at = surroundings.isr_read(0, now);
  ASSERT_TRUE(at);
  EXPECT_EQ((*at).velocity.raw(), -(1 << 22));  // -50 * 2 * 0.0025 = -0.25
  EXPECT_EQ((*at).sheath.raw(), 19 << 16);      // -4 * 0.25 + 20
  EXPECT_EQ((*at).winding.raw(), 20 << 16);     // (84 - 4) * 250 mC
  EXPECT_EQ((*at).rotor.raw, 0);
}

TEST_F(SurroundingsTest, AreMissingWhereTheyAreTooOld) {
  Surroundings surroundings(config_, folder_ / ".");
  const hal::Time start = hal::seconds(100);
  surroundings.take(frame_of(0x1a0, {0, 0, 0}), start);
  surroundings.poll(start);
  EXPECT_TRUE(surroundings.isr_read(0, start + hal::milliseconds(500)));
  EXPECT_EQ(surroundings.isr_read(0, start + hal::milliseconds(501)).error(), hal::Error::missing);
  surroundings.take(frame_of(0x1a0, {0, 0, 0}), start + hal::milliseconds(900));
  EXPECT_TRUE(surroundings.isr_read(0, start + hal::milliseconds(1'000)));
  EXPECT_EQ(surroundings.isr_read(0, start + hal::milliseconds(1'001)).error(), hal::Error::missing)
      << "the winding";
}

TEST_F(SurroundingsTest, ThatAreNoNumberOrTooLargeAreErrors) {
  config_.tendons[0].covariates[2].reset();
  config_.tendons[0].covariates[3].reset();
  Surroundings surroundings(config_, folder_ / ".");
  put("in_anglvel0_raw", "soon");
  EXPECT_EQ(surroundings.isr_read(0, hal::seconds(1)).error(), hal::Error::failed);
  put("in_anglvel0_raw", "100000");  // 500 m/s
  EXPECT_EQ(surroundings.isr_read(0, hal::seconds(1)).error(), hal::Error::out_of_range);
}

TEST_F(SurroundingsTest, ThatAreNotThereAreRefused) {
  config_.tendons[0].covariates[1] = IioQuantity{"other", "in_angl0", 1};
  EXPECT_THROW(Surroundings(config_, folder_ / "."), hal::linux_os::DeviceError);
}

TEST_F(SurroundingsTest, AreWhatIsMeasuredAndListenedTo) {
  const auto measured = measured_by(config_.tendons[0]);
  EXPECT_TRUE(measured.velocity);
  EXPECT_FALSE(measured.rotor);
  EXPECT_TRUE(measured.sheath);
  EXPECT_TRUE(measured.winding);
  const auto filters = filters_of(config_);
  ASSERT_EQ(filters.size(), 1u);
  EXPECT_EQ(filters[0].id, 0x1a0u);
}

}  // namespace
}  // namespace boards::linux_controller
