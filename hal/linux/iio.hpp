#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hal/devices.hpp"
#include "hal/error.hpp"
#include "hal/linux/descriptor.hpp"
#include "lifemodel/quantity/units.hpp"

namespace hal::linux_os {

/// How a value lies in a scan: the `_type` attribute of a scan element (sysfs-bus-iio).
struct IioType {
  bool big_endian = false;
  bool is_signed = false;
  unsigned bits = 0;           ///< that count, 1 .. 63, and 64 where signed
  unsigned storage_bytes = 0;  ///< 1, 2, 4 or 8
  unsigned shift = 0;          ///< to the right, before the bits are taken

  friend bool operator==(const IioType&, const IioType&) = default;
};

/// Reads `[be|le]:[s|u]bits/storagebits[>>shift]`; nothing where it is not of that form. A repeat
/// (`X2`) is refused: such an element is no single value.
std::optional<IioType> parse_iio_type(std::string_view text);

/// The value of a scan element. @pre element.size() == type.storage_bytes
std::int64_t iio_value(const IioType& type, std::span<const std::byte> element);

/// A channel, and what its unit is worth.
struct IioChannelSpec {
  std::string channel;  ///< e.g. `in_current0`, or `in_voltage1` behind a shunt amplifier
  /// A for a channel of motor current; the unit of IIO is 1 mA, 1 mV for voltages, 0.001 degrees
  /// Celsius, 1 rad.
  double per_unit = 1e-3;
};

/// Turns raw values of a channel into what it measures: (raw + offset) * scale * per_unit
/// (sysfs-bus-iio, in_current_raw).
class IioScale {
 public:
  /// Reads `_scale` and `_offset` of the channel, or those that all channels of its type share; an
  /// offset may be absent. Throws DeviceError.
  IioScale(const std::filesystem::path& device, const IioChannelSpec& spec);

  /// In the unit that the specification counts in.
  [[nodiscard]] double value(std::int64_t raw) const {
    return (static_cast<double>(raw) + offset_) * per_step_;
  }
  /// failed where the current is outside what MotorCurrent holds.
  [[nodiscard]] Result<lifemodel::MotorCurrent> current(std::int64_t raw) const;

 private:
  double offset_ = 0;
  double per_step_ = 0;
};

/// The folder of a device in sysfs, by `iio:device0` or by its name attribute. Throws DeviceError
/// that says which devices there are.
std::filesystem::path find_iio_device(const std::filesystem::path& sysfs,
                                      const std::string& device);

/// The text of an attribute without its line end; nothing where it cannot be read.
std::optional<std::string> read_attribute(const std::filesystem::path& path);

/// The `_raw` attribute of a channel. Each read starts a conversion and takes as long as it does.
class IioValue {
 public:
  /// Throws DeviceError where the channel is missing.
  IioValue(const std::filesystem::path& device, const IioChannelSpec& spec);

  /// missing: no value yet.
  [[nodiscard]] Result<std::int64_t> isr_raw() const;
  [[nodiscard]] const IioScale& scale() const { return scale_; }

 private:
  Descriptor raw_;
  IioScale scale_;
};

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
  std::vector<IioValue> channels_;
};
static_assert(CurrentSensor<IioSysfs>);

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
