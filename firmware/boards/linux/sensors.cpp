#include "firmware/boards/linux/sensors.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>
#include <type_traits>
#include <vector>

#include "hal/files/input_error.hpp"
#include "lifemodel/pack/pack.hpp"
#include "lifemodel/pack/samples.hpp"

namespace boards::linux_controller {
namespace {

namespace fs = std::filesystem;
using hal::files::InputError;
using hal::files::InputKind;
using hal::files::ProfileReader;
using hal::files::ProfileRow;
using lifemodel::Direction;
using lifemodel::MotorCurrent;
using lifemodel::Tension;
using lifemodel::extension::DriveSample;
using lifemodel::extension::SheathSample;

template <class SampleT>
constexpr bool kIsDrive = std::is_same_v<SampleT, DriveSample>;
template <class SampleT>
constexpr InputKind kKind = kIsDrive<SampleT>                  ? InputKind::kMotorCurrent
                            : std::is_same_v<SampleT, Tension> ? InputKind::kInputTension
                                                               : InputKind::kOutputTension;

template <class Q>
std::optional<Q> within_range(double value) {
  if (!(std::fabs(value) <= lifemodel::pack::to_double(Q::highest()))) {
    return std::nullopt;
  }
  return lifemodel::pack::from_double<Q>(value);
}

/// Turns rows into samples.
template <class SampleT>
class Conversion {
 public:
  Conversion(const lifemodel::Parameters& parameters, bool has_bend_angle)
      : parameters_(parameters),
        ultimate_N_(lifemodel::pack::ultimate_tension_N(parameters)),
        has_bend_angle_(has_bend_angle) {}

  std::optional<SampleT> operator()(const ProfileRow& row) {
    if constexpr (std::is_same_v<SampleT, MotorCurrent>) {
      return within_range<MotorCurrent>(row.value);
    } else if constexpr (std::is_same_v<SampleT, Tension>) {
      return within_range<Tension>(row.value / ultimate_N_);
    } else if constexpr (std::is_same_v<SampleT, app::OutputTension>) {
      return output(row);
    } else {
      return extended(row);
    }
  }

 private:
  // Zero velocity keeps the direction, which is pulling at the start.
  std::optional<app::OutputTension> output(const ProfileRow& row) {
    if (row.tendon_velocity_m_s != 0) {
      direction_ = row.tendon_velocity_m_s > 0 ? Direction::pulling : Direction::releasing;
    }
    const auto tension = within_range<Tension>(row.value / ultimate_N_);
    // What is faster than it can hold has gone far enough in one sample.
    const auto velocity = lifemodel::pack::from_double<app::Velocity>(row.tendon_velocity_m_s);
    return tension ? std::optional(app::OutputTension{*tension, direction_, bend(row), velocity})
                   : std::nullopt;
  }

  std::optional<SampleT> extended(const ProfileRow& row) const {
    lifemodel::Flags flags;
    const auto at =
        lifemodel::pack::covariates({row.tendon_velocity_m_s, row.motor_angle_rad,
                                     row.sheath_temperature_C, row.winding_temperature_C},
                                    flags);
    if (!flags.none()) {
      return std::nullopt;
    }
    if constexpr (kIsDrive<SampleT>) {
      const auto current = within_range<MotorCurrent>(row.value);
      return current ? std::optional(SampleT{*current, at}) : std::nullopt;
    } else {
      const auto tension = within_range<Tension>(row.value / ultimate_N_);
      return tension ? std::optional(SampleT{*tension, bend(row), at}) : std::nullopt;
    }
  }

  [[nodiscard]] lifemodel::Angle bend(const ProfileRow& row) const {
    return has_bend_angle_ ? lifemodel::pack::from_double<lifemodel::Angle>(row.bend_angle_deg *
                                                                            std::numbers::pi / 180)
                           : parameters_.bend;
  }

  const lifemodel::Parameters& parameters_;
  double ultimate_N_;
  bool has_bend_angle_;
  Direction direction_ = Direction::pulling;
};

/// Counts the periods from one row to the next.
class RowClock {
 public:
  RowClock(const fs::path& path, std::uint32_t period_us)
      : path_(path), period_s_(period_us * 1e-6) {}

  /// Periods since the last row, at least 1; 1 for the first row.
  std::size_t periods_to(double time_s) {
    const double periods = started_ ? (time_s - time_s_) / period_s_ : 1;
    const double whole = std::round(periods);
    if (whole < 1 || std::fabs(periods - whole) > 0.1 || whole > double{kMostSamples}) {
      throw InputError(path_.string(), 0, 0,
                       fmt::format("rows at {} s and {} s, which are {:.6g} periods of {} us apart",
                                   time_s_, time_s, periods, std::lround(period_s_ * 1e6)),
                       "a profile at rate_Hz of the loop; rows may be missing");
    }
    started_ = true;
    time_s_ = time_s;
    return static_cast<std::size_t>(whole);
  }

 private:
  const fs::path& path_;
  double period_s_;
  double time_s_ = 0;
  bool started_ = false;
};

template <class SampleT>
void append(RecordedSamples<SampleT>& recorded, std::size_t periods,
            const std::optional<SampleT>& sample, const fs::path& path) {
  const std::size_t size = recorded.samples.size() + periods;
  if (size > kMostSamples) {
    throw InputError(path.string(), 0, 0, "too long to be played from memory",
                     fmt::format("a profile of at most {} periods", kMostSamples));
  }
  recorded.samples.resize(size);
  recorded.holes.resize(size, true);
  if (sample) {
    recorded.samples.back() = *sample;
    recorded.holes.back() = false;
  }
}

}  // namespace

InputKind kind_of(std::span<const fs::path> profiles) {
  const InputKind kind = ProfileReader(profiles.front()).kind();
  for (const fs::path& path : profiles) {
    const InputKind other = ProfileReader(path).kind();
    if (other != kind) {
      throw InputError(path.string(), 0, 0,
                       fmt::format("holds {}, and {} holds {}", hal::files::to_string(other),
                                   profiles.front().string(), hal::files::to_string(kind)),
                       "profiles of one kind for all tendons");
    }
  }
  return kind;
}

template <class SampleT>
RecordedSamples<SampleT> read_samples(const fs::path& path,
                                      const lifemodel::Parameters& parameters) {
  ProfileReader reader(path, {kKind<SampleT>});
  Conversion<SampleT> convert(parameters, reader.has_bend_angle());
  RowClock clock(path, parameters.sample_period_us);
  RecordedSamples<SampleT> recorded;
  std::array<ProfileRow, 256> rows{};
  while (const std::size_t count = reader.read(rows)) {
    for (const ProfileRow& row : std::span(rows).first(count)) {
      append(recorded, clock.periods_to(row.time_s), convert(row), path);
    }
  }
  return recorded;
}

template RecordedSamples<Tension> read_samples(const fs::path&, const lifemodel::Parameters&);
template RecordedSamples<app::OutputTension> read_samples(const fs::path&,
                                                          const lifemodel::Parameters&);
template RecordedSamples<DriveSample> read_samples(const fs::path&, const lifemodel::Parameters&);
template RecordedSamples<SheathSample> read_samples(const fs::path&, const lifemodel::Parameters&);

namespace {

std::vector<fs::path> profiles_of(const Config& config) {
  std::vector<fs::path> profiles;
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

lifemodel::extension::Input input_of(const Config& config) {
  using lifemodel::extension::Input;
  if (config.sensor.kind != SensorKind::profile) {
    return Input::motor_current;
  }
  switch (profile_kind(config)) {
    case InputKind::kInputTension:
      return Input::input_tension;
    case InputKind::kMotorCurrent:
      return Input::motor_current;
    case InputKind::kOutputTension:
      break;
  }
  return Input::output_tension;
}

lifemodel::extension::Measured measured_by(const Config& config, const TendonConfig& tendon) {
  if (config.sensor.kind != SensorKind::profile) {
    return measured_by(tendon);
  }
  const hal::files::ProfileChannels columns = ProfileReader(tendon.profile).channels();
  return {columns[hal::files::kTendonVelocity], columns[hal::files::kMotorAngle],
          columns[hal::files::kSheathTemperature], columns[hal::files::kWindingTemperature]};
}

bool measures_current(const Config& config) {
  return input_of(config) == lifemodel::extension::Input::motor_current;
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
  throw std::logic_error("a profile has no channels of IIO");
}

}  // namespace boards::linux_controller
