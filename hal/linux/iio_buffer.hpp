#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "hal/linux/descriptor.hpp"
#include "hal/linux/iio_channel.hpp"
#include "hal/sensor.hpp"

namespace hal::linux_os {

/// Motor current from the buffer of an IIO device, one channel a tendon: a trigger of the kernel
/// samples, and a read takes what has come without waiting. The newest scan counts.
class IioBuffer {
 public:
  using Sample = lifemodel::MotorCurrent;

  /// Turns on exactly these channels and the buffer; with `trigger` not empty sets it first. Throws
  /// DeviceError.
  IioBuffer(const std::string& device, std::span<const IioChannelSpec> channels,
            const std::string& trigger, const std::filesystem::path& sysfs = "/sys",
            const std::filesystem::path& dev = "/dev");
  IioBuffer(const IioBuffer&) = delete;
  IioBuffer& operator=(const IioBuffer&) = delete;
  /// Turns the buffer off.
  ~IioBuffer();

  /// missing: no scan since the last call. out_of_range: no such tendon.
  Result<Sample> isr_read(std::size_t tendon);

  /// Scans that a newer one has overtaken.
  [[nodiscard]] std::uint64_t overtaken() const { return overtaken_; }

 private:
  static constexpr std::size_t kBufferBytes = 4'096;

  struct Channel {
    IioScale scale;
    IioType type;
    unsigned index;      ///< place among the elements of a scan
    std::size_t offset;  ///< in bytes from the start of a scan
    bool fresh;
  };

  void write(const std::string& attribute, const std::string& value) const;
  void turn_off_all_channels() const;
  void add(const IioChannelSpec& spec);
  void lay_out();
  Error take_scans();

  std::filesystem::path folder_;
  std::vector<Channel> channels_;
  std::size_t scan_bytes_ = 0;
  std::vector<std::byte> newest_;
  alignas(8) std::array<std::byte, kBufferBytes> buffer_{};
  std::uint64_t overtaken_ = 0;
  Descriptor scans_;
};
static_assert(CurrentSensor<IioBuffer>);

}  // namespace hal::linux_os
