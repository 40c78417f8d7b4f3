#include "hal/linux/iio_sysfs.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>

#include "hal/linux/device_error.hpp"

namespace hal::linux_os {
namespace {

Descriptor open_raw(const std::filesystem::path& device, const std::string& channel) {
  Descriptor raw(::open((device / (channel + "_raw")).c_str(), O_RDONLY | O_CLOEXEC));
  if (!raw) {
    throw DeviceError(device.string(), channel + "_raw: " + std::strerror(errno),
                      "a channel of this device that can be read");
  }
  return raw;
}

}  // namespace

IioSysfs::IioSysfs(const std::string& device, std::span<const IioChannelSpec> channels,
                   const std::filesystem::path& sysfs) {
  const std::filesystem::path folder = find_iio_device(sysfs, device);
  for (const IioChannelSpec& spec : channels) {
    channels_.push_back({open_raw(folder, spec.channel), IioScale(folder, spec)});
  }
}

Result<IioSysfs::Sample> IioSysfs::isr_read(std::size_t tendon) {
  if (tendon >= channels_.size()) {
    return Error::out_of_range;
  }
  const Channel& channel = channels_[tendon];
  std::array<char, 32> text{};
  const ssize_t size = ::pread(channel.raw.get(), text.data(), text.size(), 0);
  if (size <= 0) {
    return errno == EAGAIN ? Error::missing : Error::failed;
  }
  const char* const end = text.data() + size;
  std::int64_t raw = 0;
  const auto [at, error] = std::from_chars(text.data(), end, raw);
  if (error != std::errc() || (at != end && *at != '\n')) {
    return Error::failed;
  }
  return channel.scale.current(raw);
}

}  // namespace hal::linux_os
