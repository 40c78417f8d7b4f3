#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "hal/result.hpp"
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

/// The value of a scan element. Precondition: element.size() == type.storage_bytes.
std::int64_t iio_value(const IioType& type, std::span<const std::byte> element);

/// A channel that measures motor current.
struct IioChannelSpec {
  std::string channel;            ///< e.g. `in_current0`, or `in_voltage1` behind a shunt amplifier
  double ampere_per_unit = 1e-3;  ///< the unit of IIO is 1 mA, and 1 mV for voltages
};

/// Turns raw values of a channel into current: (raw + offset) * scale * ampere_per_unit
/// (sysfs-bus-iio, in_current_raw).
class IioScale {
 public:
  /// Reads `_scale` and `_offset` of the channel, or those that all channels of its type share; an
  /// offset may be absent. Throws DeviceError.
  IioScale(const std::filesystem::path& device, const IioChannelSpec& spec);

  /// failed where the current is outside what MotorCurrent holds.
  [[nodiscard]] Result<lifemodel::MotorCurrent> current(std::int64_t raw) const;

 private:
  double offset_ = 0;
  double ampere_per_step_ = 0;
};

/// The folder of a device in sysfs, by `iio:device0` or by its name attribute. Throws DeviceError
/// that says which devices there are.
std::filesystem::path find_iio_device(const std::filesystem::path& sysfs,
                                      const std::string& device);

/// The text of an attribute without its line end; nothing where it cannot be read.
std::optional<std::string> read_attribute(const std::filesystem::path& path);

}  // namespace hal::linux_os
