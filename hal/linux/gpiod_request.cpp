#include "hal/linux/gpiod_request.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <optional>
#include <system_error>

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

}  // namespace hal::linux_os
