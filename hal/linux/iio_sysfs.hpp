#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "hal/linux/descriptor.hpp"
#include "hal/linux/iio_channel.hpp"
#include "hal/sensor.hpp"

namespace hal::linux_os {

/// Motor current from the `_raw` attributes of an IIO device, one channel a tendon. Each read
/// starts a conversion and takes as long as it does: use it for slow loops, and IioBuffer for fast
/// ones.
///
/// sysfs and the character device are used as they are. The kernel keeps that interface stable, a
/// read is one system call that allocates nothing, and no library has to be there for each target.
class IioSysfs {
 public:
  using Sample = lifemodel::MotorCurrent;

  /// Throws DeviceError where the device or a channel is missing.
  IioSysfs(const std::string& device, std::span<const IioChannelSpec> channels,
           const std::filesystem::path& sysfs = "/sys");

  /// Every read is a new sample. out_of_range: no such tendon.
  Result<Sample> isr_read(std::size_t tendon);

 private:
  struct Channel {
    Descriptor raw;
    IioScale scale;
  };
  std::vector<Channel> channels_;
};
static_assert(CurrentSensor<IioSysfs>);

}  // namespace hal::linux_os
