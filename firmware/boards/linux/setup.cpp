#include "firmware/boards/linux/setup.hpp"

#include <algorithm>
#include <string>

#include "firmware/boards/linux/node_files.hpp"
#include "firmware/boards/linux/sensors.hpp"
#include "hal/files/input_error.hpp"

namespace board {
namespace {

using hal::files::InputError;

app::Config node_of(const Config& config) {
  app::Config node;
  node.node = config.node;
  if (config.authority_key) {
    node.key = read_authority_key(*config.authority_key);
  }
  std::transform(config.serial.begin(), config.serial.end(), node.serial.begin(),
                 [](char c) { return static_cast<std::byte>(c); });
  return node;
}

// With a virtual clock nothing else may take its time.
void check_virtual(const Config& config) {
  const bool alone = config.can.interface == kNoBus && !config.gpio &&
                     config.sensor.kind == SensorKind::profile &&
                     config.sensor.at_end == AtEnd::stop;
  if (!alone) {
    throw InputError("--virtual-clock", 0, 0, "the configuration has devices that run in real time",
                     "[can] interface \"none\", [gpio] chip \"none\", and a [sensor] of kind "
                     "\"profile\" with at_end \"stop\"");
  }
}

void check_drive(const Setup& setup) {
  if (!measures_current(setup.config)) {
    return;
  }
  for (std::size_t i = 0; i < setup.parameters.size(); ++i) {
    if (!setup.parameters[i].has_drive()) {
      throw InputError(setup.config.tendons[i].parameters.string(), 0, 0,
                       "made of a model without [drive], and the sensor measures motor current",
                       "a parameter block of a model with [drive]");
    }
  }
}

}  // namespace

Setup read_setup(const Config& config, bool virtual_clock) {
  if (virtual_clock) {
    check_virtual(config);
  }
  Setup setup{config, node_of(config), {}, virtual_clock};
  for (const TendonConfig& tendon : config.tendons) {
    setup.parameters.push_back(read_parameters(tendon.parameters, config.loop.period_us));
  }
  check_drive(setup);
  return setup;
}

Report run(const Setup& setup, const std::atomic<bool>& stop) {
  switch (setup.config.tendons.size()) {
    case 1:
      return run_tendons<1>(setup, stop);
    case 2:
      return run_tendons<2>(setup, stop);
    case 3:
      return run_tendons<3>(setup, stop);
    default:
      return run_tendons<4>(setup, stop);
  }
}

}  // namespace board
