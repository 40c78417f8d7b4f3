// Whatever the bytes: a configuration with every value in its range or an InputError.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "firmware/boards/linux/config.hpp"
#include "hal/files/input_error.hpp"
#include "tests/fuzz/io/require.hpp"

using host_sim::fuzz::require;

namespace {

void require_whole(const boards::linux_controller::Config& config) {
  require(config.node >= 1 && config.node <= 127);
  require(config.serial.size() <= 12);
  require(!config.can.interface.empty());
  require(config.can.log.empty() || config.can.interface == boards::linux_controller::kNoBus);
  require(config.loop.period_us >= 50 && config.loop.period_us <= 1'000'000);
  require(config.loop.priority >= 1 && config.loop.priority <= 98);
  require(!config.store.empty());
  require(!config.tendons.empty() &&
          config.tendons.size() <= boards::linux_controller::kMostTendons);
  for (const boards::linux_controller::TendonConfig& tendon : config.tendons) {
    require(!tendon.parameters.empty());
    require(tendon.profile.empty() ==
            (config.sensor.kind != boards::linux_controller::SensorKind::profile));
    require(tendon.channel.empty() ==
            (config.sensor.kind == boards::linux_controller::SensorKind::profile));
    require(tendon.channel.find('/') == std::string::npos);
  }
  if (config.gpio) {
    require(!config.gpio->drive_enable.line.empty() && !config.gpio->brake.line.empty());
    require(!config.gpio->emergency_stop.line.empty());
    require(config.gpio->debounce.count() >= 1'000 && config.gpio->debounce.count() <= 5'000);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    require_whole(boards::linux_controller::parse_config(text, "fuzz", "/folder"));
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
  }
  return 0;
}
