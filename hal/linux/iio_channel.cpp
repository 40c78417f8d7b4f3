#include "hal/linux/iio_channel.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include "hal/linux/device_error.hpp"
#include "lifemodel/pack/pack.hpp"

namespace hal::linux_os {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDigits = "0123456789";

/// Takes texts and numbers off the front of a text.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  bool skip(std::string_view expected) {
    if (!rest_.starts_with(expected)) {
      return false;
    }
    rest_.remove_prefix(expected.size());
    return true;
  }
  bool number(unsigned& value) {
    const auto [at, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    rest_.remove_prefix(static_cast<std::size_t>(at - rest_.data()));
    return error == std::errc();
  }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

std::optional<double> finite_number(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && at == end && std::isfinite(value) ? std::optional(value)
                                                                   : std::nullopt;
}

// `in_current` of `in_current0`, `in_voltage-voltage` of `in_voltage1-voltage2`.
std::string type_of(const std::string& channel) {
  std::string type;
  for (const char letter : channel) {
    if (letter == '-') {
      type.erase(type.find_last_not_of(kDigits) + 1);
    }
    type += letter;
  }
  return type.erase(type.find_last_not_of(kDigits) + 1);
}

std::optional<std::string> shared_attribute(const fs::path& device, const std::string& channel,
                                            const std::string& suffix) {
  auto own = read_attribute(device / (channel + suffix));
  return own ? own : read_attribute(device / (type_of(channel) + suffix));
}

std::string described_devices(const fs::path& devices) {
  std::vector<std::string> all;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(devices, error)) {
    const std::string folder = entry.path().filename().string();
    if (folder.starts_with("iio:device")) {
      all.push_back(folder + " (" + read_attribute(entry.path() / "name").value_or("no name") +
                    ")");
    }
  }
  std::sort(all.begin(), all.end());
  std::string text;
  for (const std::string& one : all) {
    text.append(text.empty() ? "" : ", ").append(one);
  }
  return text.empty() ? "none" : text;
}

}  // namespace

std::optional<std::string> read_attribute(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  if (!file || !std::getline(file, line)) {
    return std::nullopt;
  }
  line.erase(line.find_last_not_of(" \t\r") + 1);
  return line;
}

std::optional<IioType> parse_iio_type(std::string_view text) {
  IioType type;
  Scanner in(text);
  type.big_endian = in.skip("be:");
  if (!type.big_endian && !in.skip("le:")) {
    return std::nullopt;
  }
  type.is_signed = in.skip("s");
  unsigned storage = 0;
  if ((!type.is_signed && !in.skip("u")) || !in.number(type.bits) || !in.skip("/") ||
      !in.number(storage) || (in.skip(">>") && !in.number(type.shift)) || !in.at_end()) {
    return std::nullopt;
  }
  const bool whole = storage == 8 || storage == 16 || storage == 32 || storage == 64;
  const bool too_wide = type.bits == 64 && !type.is_signed;
  if (!whole || too_wide || type.bits == 0 || type.shift >= storage ||
      type.bits > storage - type.shift) {
    return std::nullopt;
  }
  type.storage_bytes = storage / 8;
  return type;
}

std::int64_t iio_value(const IioType& type, std::span<const std::byte> element) {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < element.size(); ++i) {
    const std::size_t at = type.big_endian ? i : element.size() - 1 - i;
    word = (word << 8) | std::to_integer<std::uint64_t>(element[at]);
  }
  const unsigned above = 64 - type.bits;
  word = (word >> type.shift) << above;
  return type.is_signed ? static_cast<std::int64_t>(word) >> above
                        : static_cast<std::int64_t>(word >> above);
}

IioScale::IioScale(const fs::path& device, const IioChannelSpec& spec) {
  const auto scale = shared_attribute(device, spec.channel, "_scale");
  const auto step = scale ? finite_number(*scale) : std::nullopt;
  if (!step || *step == 0) {
    throw DeviceError(device.string(),
                      spec.channel + "_scale is " + scale.value_or("missing or unreadable"),
                      "a channel with a scale other than 0");
  }
  const auto offset = shared_attribute(device, spec.channel, "_offset");
  const auto steps = finite_number(offset.value_or("0"));
  if (!steps) {
    throw DeviceError(device.string(), spec.channel + "_offset is " + *offset, "a number");
  }
  offset_ = *steps;
  ampere_per_step_ = *step * spec.ampere_per_unit;
}

Result<lifemodel::MotorCurrent> IioScale::current(std::int64_t raw) const {
  const double current_A = (static_cast<double>(raw) + offset_) * ampere_per_step_;
  if (!(std::fabs(current_A) <= lifemodel::pack::to_double(lifemodel::MotorCurrent::highest()))) {
    return Error::failed;
  }
  return lifemodel::pack::from_double<lifemodel::MotorCurrent>(current_A);
}

fs::path find_iio_device(const fs::path& sysfs, const std::string& device) {
  const fs::path devices = sysfs / "bus/iio/devices";
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(devices, error)) {
    if (entry.path().filename().string().starts_with("iio:device") &&
        (entry.path().filename() == device ||
         read_attribute(entry.path() / "name").value_or("") == device)) {
      return entry.path();
    }
  }
  throw DeviceError(device, "no such IIO device",
                    "name of an IIO device; there are: " + described_devices(devices));
}

}  // namespace hal::linux_os
