#include "hal/linux/gpiod_lines.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <exception>
#include <filesystem>
#include <optional>
#include <system_error>

#include "hal/devices.hpp"
#include "hal/linux/device_error.hpp"

namespace hal::linux_os {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> chip_paths() {
  std::vector<fs::path> paths;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator("/dev", error)) {
    if (entry.path().filename().string().starts_with("gpiochip") &&
        ::gpiod::is_gpiochip_device(entry.path())) {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string described_chips() {
  std::string text;
  for (const fs::path& path : chip_paths()) {
    text.append(text.empty() ? "" : ", ").append(path.string());
    try {
      text.append(" (").append(::gpiod::chip(path).get_info().label()).append(")");
    } catch (const std::exception&) {
      text.append(" (cannot be opened)");
    }
  }
  return text.empty() ? "none" : text;
}

bool is_called(const fs::path& path, const std::string& chip) {
  if (path.filename() == chip) {
    return true;
  }
  try {
    return ::gpiod::chip(path).get_info().label() == chip;
  } catch (const std::exception&) {
    return false;
  }
}

fs::path path_of(const std::string& chip) {
  if (chip.starts_with('/')) {
    return chip;
  }
  for (const fs::path& path : chip_paths()) {
    if (is_called(path, chip)) {
      return path;
    }
  }
  throw DeviceError(chip, "no such gpiochip",
                    "path, name or label of a gpiochip; there are: " + described_chips());
}

std::optional<unsigned> offset_in_digits(const std::string& text) {
  unsigned offset = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, offset);
  return error == std::errc() && at == end ? std::optional(offset) : std::nullopt;
}

unsigned offset_of(const std::string& name, const ::gpiod::chip& chip, const LineSpec& spec) {
  const std::size_t count = chip.get_info().num_lines();
  if (const auto offset = offset_in_digits(spec.line)) {
    if (*offset < count) {
      return *offset;
    }
  } else if (const int found = chip.get_line_offset_from_name(spec.line); found >= 0) {
    return static_cast<unsigned>(found);
  }
  throw DeviceError(name, "no line '" + spec.line + "'",
                    "the name of a line (see gpioinfo), or an offset 0.." +
                        std::to_string(count == 0 ? 0 : count - 1));
}

[[noreturn]] void fail_request(const std::string& name, const ::gpiod::chip& chip,
                               std::span<const LineSpec> lines,
                               const std::vector<::gpiod::line::offset>& offsets,
                               const std::system_error& error) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const ::gpiod::line_info info = chip.get_line_info(offsets[i]);
    if (info.used()) {
      throw DeviceError(name, "line '" + lines[i].line + "' is in use by '" + info.consumer() + "'",
                        "a line that nobody else holds");
    }
  }
  throw DeviceError(name, "line '" + lines.front().line + "': " + error.code().message(),
                    "lines that can be requested so");
}

}  // namespace

::gpiod::chip open_gpio_chip(const std::string& chip) {
  const fs::path path = path_of(chip);
  try {
    return ::gpiod::chip(path);
  } catch (const std::system_error& error) {
    throw DeviceError(chip, error.code().message(),
                      "a gpiochip that this user may open; there are: " + described_chips());
  }
}

::gpiod::line_request request_lines(const std::string& name, std::span<const LineSpec> lines,
                                    ::gpiod::line_settings settings,
                                    std::vector<::gpiod::line::offset>& offsets) {
  ::gpiod::chip chip = open_gpio_chip(name);
  ::gpiod::line_config config;
  offsets.clear();
  for (const LineSpec& spec : lines) {
    offsets.push_back(offset_of(name, chip, spec));
    if (std::count(offsets.begin(), offsets.end(), offsets.back()) > 1) {
      throw DeviceError(name, "line '" + spec.line + "' is named twice", "one use for each line");
    }
    settings.set_active_low(spec.active_low);
    config.add_line_settings(offsets.back(), settings);
  }
  try {
    return chip.prepare_request().set_consumer(kGpioConsumer).set_line_config(config).do_request();
  } catch (const std::system_error& error) {
    fail_request(name, chip, lines, offsets, error);
  }
}

static_assert(DigitalOut<GpioOutput>);

GpioOutputs::GpioOutputs(const std::string& chip, std::span<const LineSpec> lines)
    : request_(request_lines(chip, lines,
                             ::gpiod::line_settings()
                                 .set_direction(::gpiod::line::direction::OUTPUT)
                                 .set_output_value(::gpiod::line::value::INACTIVE),
                             offsets_)) {}

Error GpioOutputs::set(std::size_t i, bool asserted) {
  try {
    request_.set_value(offsets_[i],
                       asserted ? ::gpiod::line::value::ACTIVE : ::gpiod::line::value::INACTIVE);
    return Error::none;
  } catch (const std::exception&) {
    return Error::failed;
  }
}

static_assert(DigitalIn<GpioEmergencyStop>);

GpioEdges::GpioEdges(const std::string& chip, const LineSpec& line,
                     std::chrono::microseconds debounce)
    : request_(request_lines(chip, std::span(&line, 1),
                             ::gpiod::line_settings()
                                 .set_direction(::gpiod::line::direction::INPUT)
                                 .set_edge_detection(::gpiod::line::edge::BOTH)
                                 .set_event_clock(::gpiod::line::clock::MONOTONIC)
                                 .set_debounce_period(debounce),
                             offsets_)),
      buffer_(kBufferEdges) {}

Result<std::size_t> GpioEdges::read(std::span<Edge> out) {
  try {
    if (!request_.wait_edge_events(std::chrono::nanoseconds(0))) {
      return std::size_t{0};
    }
    const std::size_t count =
        request_.read_edge_events(buffer_, std::min(out.size(), buffer_.capacity()));
    for (std::size_t i = 0; i < count; ++i) {
      const ::gpiod::edge_event& event = buffer_.get_event(static_cast<unsigned>(i));
      out[i] = {event.type() == ::gpiod::edge_event::event_type::RISING_EDGE,
                static_cast<std::uint32_t>(event.global_seqno()),
                static_cast<std::uint32_t>(event.line_seqno()), event.timestamp_ns().ns()};
    }
    return count;
  } catch (const std::exception&) {
    return Error::failed;
  }
}

Result<bool> GpioEdges::level() {
  try {
    return request_.get_value(offsets_.front()) == ::gpiod::line::value::ACTIVE;
  } catch (const std::exception&) {
    return Error::failed;
  }
}

}  // namespace hal::linux_os
