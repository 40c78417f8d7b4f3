#include "hal/linux/iio_buffer.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>

#include "hal/linux/device_error.hpp"

namespace hal::linux_os {
namespace {

namespace fs = std::filesystem;

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
