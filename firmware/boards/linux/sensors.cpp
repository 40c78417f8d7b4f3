#include "firmware/boards/linux/sensors.hpp"

#include <filesystem>
#include <vector>

namespace board {
namespace {

std::vector<std::filesystem::path> profiles_of(const Config& config) {
  std::vector<std::filesystem::path> profiles;
  for (const TendonConfig& tendon : config.tendons) {
    profiles.push_back(tendon.profile);
  }
  return profiles;
}

std::vector<hal::linux_os::IioChannelSpec> channels_of(const Config& config) {
  std::vector<hal::linux_os::IioChannelSpec> channels;
  for (const TendonConfig& tendon : config.tendons) {
    channels.push_back({tendon.channel, tendon.ampere_per_unit});
  }
  return channels;
}

}  // namespace

hal::files::InputKind profile_kind(const Config& config) {
  return kind_of(profiles_of(config));
}

bool measures_current(const Config& config) {
  return config.sensor.kind != SensorKind::profile ||
         profile_kind(config) == hal::files::InputKind::kMotorCurrent;
}

CurrentSensor::CurrentSensor(const Setup& setup) : source_(open(setup)) {}

CurrentSensor::Source CurrentSensor::open(const Setup& setup) {
  const SensorConfig& sensor = setup.config.sensor;
  switch (sensor.kind) {
    case SensorKind::iio:
      return hal::linux_os::IioSysfs(sensor.device, channels_of(setup.config));
    case SensorKind::iio_buffer:
      return std::make_unique<hal::linux_os::IioBuffer>(sensor.device, channels_of(setup.config),
                                                        sensor.trigger);
    case SensorKind::profile:
      break;
  }
  return profile_sensor<Sample>(setup);
}

}  // namespace board
