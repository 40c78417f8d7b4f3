#include "hal/linux/iio.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
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
  per_step_ = *step * spec.per_unit;
}

Result<lifemodel::MotorCurrent> IioScale::current(std::int64_t raw) const {
  const double current_A = value(raw);
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

namespace {

Descriptor open_raw(const fs::path& device, const std::string& channel) {
  Descriptor raw(::open((device / (channel + "_raw")).c_str(), O_RDONLY | O_CLOEXEC));
  if (!raw) {
    throw DeviceError(device.string(), channel + "_raw: " + std::strerror(errno),
                      "a channel of this device that can be read");
  }
  return raw;
}

}  // namespace

IioValue::IioValue(const fs::path& device, const IioChannelSpec& spec)
    : raw_(open_raw(device, spec.channel)), scale_(device, spec) {}

Result<std::int64_t> IioValue::isr_raw() const {
  std::array<char, 32> text{};
  const ssize_t size = ::pread(raw_.get(), text.data(), text.size(), 0);
  if (size <= 0) {
    return errno == EAGAIN ? Error::missing : Error::failed;
  }
  const char* const end = text.data() + size;
  std::int64_t raw = 0;
  const auto [at, error] = std::from_chars(text.data(), end, raw);
  if (error != std::errc() || (at != end && *at != '\n')) {
    return Error::failed;
  }
  return raw;
}

IioSysfs::IioSysfs(const std::string& device, std::span<const IioChannelSpec> channels,
                   const fs::path& sysfs) {
  const fs::path folder = find_iio_device(sysfs, device);
  for (const IioChannelSpec& spec : channels) {
    channels_.emplace_back(folder, spec);
  }
}

Result<IioSysfs::Sample> IioSysfs::isr_read(std::size_t tendon) {
  if (tendon >= channels_.size()) {
    return Error::out_of_range;
  }
  const auto raw = channels_[tendon].isr_raw();
  return raw ? channels_[tendon].scale().current(*raw) : Result<Sample>(raw.error());
}

namespace {

constexpr std::string_view kScans = "64";

std::size_t round_up(std::size_t n, std::size_t step) {
  return (n + step - 1) / step * step;
}

}  // namespace

IioBuffer::IioBuffer(const std::string& device, std::span<const IioChannelSpec> channels,
                     const std::string& trigger, const fs::path& sysfs, const fs::path& dev)
    : folder_(find_iio_device(sysfs, device)) {
  write("buffer/enable", "0");
  turn_off_all_channels();
  for (const IioChannelSpec& spec : channels) {
    add(spec);
  }
  lay_out();
  if (!trigger.empty()) {
    write("trigger/current_trigger", trigger);
  }
  write("buffer/length", std::string(kScans));
  const fs::path path = dev / folder_.filename();
  scans_ = Descriptor(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!scans_) {
    throw DeviceError(path.string(), std::strerror(errno), "a device that this user may read");
  }
  write("buffer/enable", "1");
}

IioBuffer::~IioBuffer() {
  std::ofstream(folder_ / "buffer/enable") << "0\n";
}

void IioBuffer::write(const std::string& attribute, const std::string& value) const {
  std::ofstream file(folder_ / attribute);
  file << value << '\n' << std::flush;
  if (!file) {
    throw DeviceError((folder_ / attribute).string(),
                      "cannot be set to " + value + ": " + std::strerror(errno),
                      "an IIO device with a buffer, its trigger, and the rights to set them");
  }
}

void IioBuffer::turn_off_all_channels() const {
  std::error_code error;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(folder_ / "scan_elements", error)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with("_en")) {
      write("scan_elements/" + name, "0");
    }
  }
}

void IioBuffer::add(const IioChannelSpec& spec) {
  const std::string element = "scan_elements/" + spec.channel;
  const auto type_text = read_attribute(folder_ / (element + "_type"));
  const auto type = parse_iio_type(type_text.value_or(""));
  if (!type) {
    throw DeviceError((folder_ / element).string(),
                      "_type is " + type_text.value_or("missing or unreadable"),
                      "a channel of the buffer with one value, e.g. le:s16/16>>0");
  }
  const std::string index_text = read_attribute(folder_ / (element + "_index")).value_or("");
  unsigned index = 0;
  const auto [at, error] =
      std::from_chars(index_text.data(), index_text.data() + index_text.size(), index);
  const bool taken = std::any_of(channels_.begin(), channels_.end(),
                                 [&](const Channel& other) { return other.index == index; });
  if (error != std::errc() || at != index_text.data() + index_text.size() || taken) {
    throw DeviceError((folder_ / element).string(), "_index is '" + index_text + "'",
                      "a place of its own in the scan");
  }
  channels_.push_back({IioScale(folder_, spec), *type, index, 0, false});
  write(element + "_en", "1");
}

// Elements lie in the order of their index, each aligned to its size, and a scan is a multiple of
// the largest (Documentation/driver-api/iio/buffers.rst).
void IioBuffer::lay_out() {
  std::vector<Channel*> in_order;
  for (Channel& channel : channels_) {
    in_order.push_back(&channel);
  }
  std::sort(in_order.begin(), in_order.end(),
            [](const Channel* a, const Channel* b) { return a->index < b->index; });
  std::size_t largest = 1;
  for (Channel* const channel : in_order) {
    const std::size_t bytes = channel->type.storage_bytes;
    channel->offset = round_up(scan_bytes_, bytes);
    scan_bytes_ = channel->offset + bytes;
    largest = std::max(largest, bytes);
  }
  scan_bytes_ = round_up(scan_bytes_, largest);
  newest_.resize(scan_bytes_);
}

Error IioBuffer::take_scans() {
  const std::size_t room = buffer_.size() / scan_bytes_ * scan_bytes_;
  const ssize_t size = ::read(scans_.get(), buffer_.data(), room);
  if (size <= 0) {
    return size == 0 || errno == EAGAIN || errno == EINTR ? Error::missing : Error::failed;
  }
  const auto bytes = static_cast<std::size_t>(size);
  if (bytes % scan_bytes_ != 0) {
    return Error::failed;
  }
  overtaken_ += bytes / scan_bytes_ - 1;
  std::memcpy(newest_.data(), buffer_.data() + bytes - scan_bytes_, scan_bytes_);
  for (Channel& channel : channels_) {
    channel.fresh = true;
  }
  return Error::none;
}

Result<IioBuffer::Sample> IioBuffer::isr_read(std::size_t tendon) {
  if (tendon >= channels_.size()) {
    return Error::out_of_range;
  }
  Channel& channel = channels_[tendon];
  if (!channel.fresh) {
    if (const Error error = take_scans(); error != Error::none) {
      return error;
    }
  }
  channel.fresh = false;
  return channel.scale.current(iio_value(
      channel.type, std::span(newest_).subspan(channel.offset, channel.type.storage_bytes)));
}

}  // namespace hal::linux_os
