/// Motor current from IIO of a real kernel: iio_simple_dummy, whose values are fixed. In sysfs
/// in_voltage0 is 73 and in_voltage1-voltage2 is 33; in a scan 7 and -33. Their scales are 1.333e-3
/// and 1.344e-6, and in_voltage0 has the offset 7 (drivers/iio/dummy/iio_simple_dummy.c).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <span>
#include <string>
#include <vector>

#include "hal/linux/device_error.hpp"
#include "hal/linux/iio.hpp"
#include "tests/kernel/kernel_rig.hpp"

namespace hal::linux_os {
namespace {

using namespace std::chrono_literals;

std::string device() {
  return kernel_test::setting("TENDONLIFE_CONVERTER");
}
std::string trigger() {
  return kernel_test::setting("TENDONLIFE_TRIGGER");
}

const std::vector<IioChannelSpec> kChannels{{"in_voltage0", 10.0},
                                            {"in_voltage1-voltage2", -5'000.0}};

double ampere(const Result<lifemodel::MotorCurrent>& current) {
  EXPECT_TRUE(current) << to_string(current.error());
  return current ? current->raw() / 16'777'216.0 : 0;
}

constexpr double kStep_A = 1.0 / 16'777'216.0;

TEST(IioOnKernel, ReadsTheRawAttributes) {
  IioSysfs sensor(device(), kChannels);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(ampere(sensor.isr_read(0)), (73 + 7) * 0.001333 * 10.0, kStep_A);
    EXPECT_NEAR(ampere(sensor.isr_read(1)), 33 * 1.344e-6 * -5'000.0, kStep_A);
  }
  EXPECT_EQ(sensor.isr_read(2).error(), Error::out_of_range);
}

TEST(IioOnKernel, ReadsTheBufferThatATimerFills) {
  IioBuffer sensor(device(), kChannels, trigger());
  for (int i = 0; i < 3; ++i) {
    Result<lifemodel::MotorCurrent> first = Error::missing;
    ASSERT_TRUE(kernel_test::eventually([&] {
      first = sensor.isr_read(0);
      return first || first.error() != Error::missing;
    }));
    EXPECT_NEAR(ampere(first), (7 + 7) * 0.001333 * 10.0, kStep_A);
    EXPECT_NEAR(ampere(sensor.isr_read(1)), -33 * 1.344e-6 * -5'000.0, kStep_A);
  }
}

TEST(IioOnKernel, CountsScansThatWereOvertaken) {
  IioBuffer sensor(device(), kChannels, trigger());
  kernel_test::wait(500ms);
  EXPECT_TRUE(sensor.isr_read(0));
  EXPECT_GT(sensor.overtaken(), 0u);
}

TEST(IioOnKernel, LeavesTheBufferOff) {
  { const IioBuffer sensor(device(), kChannels, trigger()); }
  EXPECT_EQ(read_attribute(find_iio_device("/sys", device()) / "buffer/enable"), "0");
}

TEST(IioOnKernel, NamesAMissingDeviceAndThoseThatAreThere) {
  try {
    IioSysfs("no_such_device", kChannels);
    FAIL();
  } catch (const DeviceError& error) {
    EXPECT_THAT(error.what(),
                testing::AllOf(testing::HasSubstr("no_such_device: no such IIO device"),
                               testing::HasSubstr(device())));
  }
}

TEST(IioOnKernel, NamesAMissingChannel) {
  const IioChannelSpec missing{"in_current9"};
  EXPECT_THROW(IioSysfs(device(), std::span(&missing, 1)), DeviceError);
  EXPECT_THROW(IioBuffer(device(), std::span(&missing, 1), trigger()), DeviceError);
}

}  // namespace
}  // namespace hal::linux_os
