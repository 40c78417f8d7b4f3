#include "hal/linux/gpiod_lines.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "hal/linux/device_error.hpp"

namespace hal::linux_os {
namespace {

std::string complaint_about_chip(const std::string& chip) {
  try {
    GpioOutput output(chip, {"DRIVE", false});
  } catch (const DeviceError& error) {
    return error.what();
  }
  return {};
}

TEST(GpioOfThisMachine, AMissingChipIsNamedWithThoseThatAreThere) {
  EXPECT_TRUE(complaint_about_chip("tl-no-chip")
                  .starts_with("tl-no-chip: no such gpiochip; accepted: path, name or label of a "
                               "gpiochip; there are: "));
  EXPECT_TRUE(complaint_about_chip("/dev/tl-no-chip")
                  .starts_with("/dev/tl-no-chip: No such file or directory; accepted: a gpiochip "
                               "that this user may open; there are: "));
}

TEST(GpioOfThisMachine, AFileThatIsNoChipIsRefused) {
  EXPECT_TRUE(complaint_about_chip("/dev/null").starts_with("/dev/null: "));
}

TEST(GpioOfThisMachine, TheEmergencyStopNeedsItsChipToo) {
  EXPECT_THROW(GpioEmergencyStop("/dev/tl-no-chip", {"0", true}, std::chrono::milliseconds(2)),
               DeviceError);
}

}  // namespace
}  // namespace hal::linux_os
