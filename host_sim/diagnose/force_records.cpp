#include "host_sim/diagnose/force_records.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "hal/files/input_error.hpp"
#include "host_sim/recording/motion.hpp"
#include "host_sim/recording/sensor.hpp"
#include "host_sim/recording/signal.hpp"
#include "host_sim/reference/equations.hpp"

namespace host_sim::diagnose {
namespace {

using enum hal::files::ProfileColumnId;
using hal::files::ProfileColumnId;
using recording::Fault;
using recording::Recording;

bool constant(const Recording& recording, const std::vector<Fault>& faults,
              ProfileColumnId channel) {
  return std::ranges::any_of(faults, [&](const Fault& fault) {
    return fault.session == recording.session && fault.channel == channel &&
           fault.kind == Fault::Kind::constant;
  });
}

ProfileColumnId input_column(const Recording& recording) {
  return recording.has(kInputTensionColumn) ? kInputTensionColumn : kMotorCurrentColumn;
}

std::vector<double> input_of(const Recording& recording, const NominalModel& nominal) {
  if (recording.has(kInputTensionColumn)) {
    return recording[kInputTensionColumn];
  }
  if (!nominal.drive) {
    throw hal::files::InputError(recording.file.string(), 0, 0,
                                 "a motor current, and no drive that makes a tension of it",
                                 "input_tension_N, or [model.drive] in campaign.toml");
  }
  const reference::Drive drive = nominal.drive->reference();
  std::vector<double> input_N = recording[kMotorCurrentColumn];
  for (double& value : input_N) {
    value = reference::input_tension_from_current(value, drive);
  }
  return input_N;
}

std::vector<double> position_of(const Recording& recording, const std::vector<double>& velocity_m_s,
                                bool rotor_known, const NominalModel& nominal) {
  if (rotor_known) {
    std::vector<double> position_m = recording[kMotorAngle];
    for (double& value : position_m) {
      value *= nominal.drive->spool_radius_m() / nominal.drive->gear_ratio;
    }
    return position_m;
  }
  return recording::integral(recording[kTime], velocity_m_s);
}

std::vector<double> angle_of(const Recording& recording, const NominalModel& nominal) {
  constexpr double kRadPerDeg = std::numbers::pi / 180;
  std::vector<double> angle_rad(recording.samples(),
                                nominal.sheath ? nominal.sheath->bend_angle_deg : 0);
  if (recording.has(kBendAngle)) {
    angle_rad = recording[kBendAngle];
  } else if (!nominal.sheath) {
    throw hal::files::InputError(recording.file.string(), 0, 0, "no bend angle",
                                 "bend_angle_deg, or [model.sheath] in campaign.toml");
  }
  for (double& value : angle_rad) {
    value *= kRadPerDeg;
  }
  return angle_rad;
}

std::vector<double> rate_of(const std::vector<double>& time_s, const std::vector<double>& values) {
  constexpr std::size_t kAround = 2;
  std::vector<double> rates(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t first = i < kAround ? 0 : i - kAround;
    const std::size_t last = std::min(i + kAround, values.size() - 1);
    rates[i] = (values[last] - values[first]) / (time_s[last] - time_s[first]);
  }
  return rates;
}

/// Cycles before the recording, and the reversals since over two.
std::vector<double> cycles_of(const Recording& recording) {
  const std::vector<double>& velocity_m_s = recording[kTendonVelocity];
  const recording::Stretch whole{0, recording.samples()};
  const recording::Motion motion = recording::motion_of(
      recording[kTime], velocity_m_s, std::span(&whole, 1), recording::dead_band_m_s(velocity_m_s));
  std::vector<double> cycles;
  for (const double reversals : motion.reversals) {
    cycles.push_back(recording.start_cycle + reversals / 2);
  }
  return cycles;
}

void leave_out(const Recording& recording, const std::vector<Fault>& faults,
               std::vector<bool>& measured) {
  for (const Fault& fault : faults) {
    if (fault.session != recording.session || fault.kind == Fault::Kind::constant ||
        fault.kind == Fault::Kind::dead_load) {
      continue;
    }
    const std::size_t end = std::min(fault.first + fault.count, measured.size());
    std::fill(measured.begin() + static_cast<std::ptrdiff_t>(std::min(fault.first, end)),
              measured.begin() + static_cast<std::ptrdiff_t>(end), false);
  }
}

double most_of(std::span<const double> velocity_m_s) {
  double most_m_s = 0;
  for (const double value_m_s : velocity_m_s) {
    most_m_s = std::max(most_m_s, std::abs(value_m_s));
  }
  return most_m_s;
}

/// Whether what is slow for a while is noise about rest: it goes as far one way as the other.
bool is_rest(std::span<const double> velocity_m_s, double noise_m_s) {
  // Half of normal noise is beyond 0.67 of its standard deviation.
  constexpr double kQuiet = 0.2;
  // A motion that turns goes from one end of the band to the other: half of its samples are beyond
  // twice the noise, in the mean, on each side.
  constexpr double kOfMean = 1.5;
  // A velocity that is quieter there than elsewhere is noise by what it is there: one that turns or
  // creeps has a mean of nearly its root mean square.
  constexpr double kOfOwnMean = 0.5;
  const std::size_t half = velocity_m_s.size() / 2;
  double quiet = 0;
  double square_m2_s2 = 0;
  for (const double value_m_s : velocity_m_s) {
    quiet += std::abs(value_m_s) <= kQuiet * noise_m_s ? 1 : 0;
    square_m2_s2 += value_m_s * value_m_s;
  }
  const double samples = static_cast<double>(velocity_m_s.size());
  const double most_m_s =
      quiet > samples / 2 ? kOfOwnMean * std::sqrt(square_m2_s2 / samples) : kOfMean * noise_m_s;
  return std::abs(effects::mean_of(velocity_m_s.first(half))) <= most_m_s &&
         std::abs(effects::mean_of(velocity_m_s.last(half))) <= most_m_s;
}

/// Without what noise makes of rest, which would move the tendon there and back.
std::vector<double> velocity_of(const Recording& recording) {
  constexpr std::size_t kLeast = 10;  // samples in a row: fewer are of a slow turn
  constexpr double kOfNoise = 4;
  constexpr double kMost = 0.25;  // of the largest speed
  std::vector<double> velocity_m_s = recording[kTendonVelocity];
  const double noise_m_s = recording::noise_sigma(velocity_m_s);
  const double least_m_s = std::min(kOfNoise * noise_m_s, kMost * most_of(velocity_m_s));
  std::vector<bool> slow;
  slow.reserve(velocity_m_s.size());
  for (const double value_m_s : velocity_m_s) {
    slow.push_back(std::abs(value_m_s) <= least_m_s);
  }
  for (const recording::Stretch& stretch : recording::stretches_of(slow, true, kLeast)) {
    const std::span<double> while_slow(&velocity_m_s[stretch.first], stretch.count);
    if (is_rest(while_slow, noise_m_s)) {
      std::ranges::fill(while_slow, 0.0);
    }
  }
  return velocity_m_s;
}

/// Within the noise of the velocity friction has no direction that is known, nor next to a while of
/// that.
void leave_out_rest(effects::ForceRecord& record, double noise_m_s) {
  constexpr double kRounding = 1e-9;  // of the largest speed
  constexpr double kOfNoise = 3;
  constexpr double kMost = 0.02;     // of the largest speed: more is no noise about rest
  constexpr std::size_t kWhile = 4;  // samples
  const double most_m_s = most_of(record.velocity_m_s);
  const double least_m_s =
      std::max(kRounding * most_m_s, std::min(kOfNoise * noise_m_s, kMost * most_m_s));
  std::vector<bool> rests;
  for (std::size_t i = 0; i < record.samples(); ++i) {
    rests.push_back(std::abs(record.velocity_m_s[i]) <= least_m_s);
    record.used[i] = record.used[i] && !rests[i];
  }
  for (const recording::Stretch& stretch : recording::stretches_of(rests, true, kWhile)) {
    if (stretch.first > 0) {
      record.used[stretch.first - 1] = false;
    }
    if (stretch.end() < record.samples()) {
      record.used[stretch.end()] = false;
    }
  }
}

/// A force that is read less often than it is logged lies behind but for the sample at which it is
/// new: where one of both does, those of the one that is new less often are left.
void leave_out_held(effects::ForceRecord& record) {
  record.input_hold = recording::hold_of(record.input_N);
  record.output_hold = recording::hold_of(record.output_N);
  if (record.input_hold == 1 && record.output_hold == 1) {
    return;
  }
  const std::vector<double>& held_N =
      record.input_hold > record.output_hold ? record.input_N : record.output_N;
  std::vector<std::size_t> fresh;
  for (const recording::Stretch& stays : recording::still_stretches(held_N, 1)) {
    if (stays.first > 0) {
      fresh.push_back(stays.first);
    }
  }
  keep(record, fresh);
  record.output_rate_N_s = rate_of(record.time_s, record.output_N);
}

/// What hardly varies shows nothing.
void leave_out_even(std::vector<effects::ForceRecord>& records,
                    std::vector<double> effects::ForceRecord::*temperature_C) {
  constexpr double kLeast_K = 3;
  double least_C = HUGE_VAL;
  double most_C = -HUGE_VAL;
  for (const effects::ForceRecord& record : records) {
    for (const double value_C : record.*temperature_C) {
      least_C = std::min(least_C, value_C);
      most_C = std::max(most_C, value_C);
    }
  }
  if (most_C - least_C < kLeast_K) {
    for (effects::ForceRecord& record : records) {
      (record.*temperature_C).clear();
    }
  }
}

/// Sessions that all begin at the same cycle do not know where in the life of the tendon they are.
void leave_out_uncounted_cycles(std::vector<effects::ForceRecord>& records) {
  const bool counted = std::ranges::any_of(records, [&](const effects::ForceRecord& record) {
    return record.cycle.front() != records.front().cycle.front();
  });
  if (!counted) {
    for (effects::ForceRecord& record : records) {
      record.cycle.clear();
    }
  }
}

/// Sessions that are short beside the life that they span have one number of cycles each: what goes
/// on within them is of other causes, however well that is known.
void take_means_of_short_sessions(std::vector<effects::ForceRecord>& records) {
  constexpr double kShort = 0.1;
  double least = HUGE_VAL;
  double most = 0;
  double longest = 0;
  for (const effects::ForceRecord& record : records) {
    if (record.cycle.empty()) {
      return;
    }
    least = std::min(least, record.cycle.front());
    most = std::max(most, record.cycle.back());
    longest = std::max(longest, record.cycle.back() - record.cycle.front());
  }
  if (longest < kShort * (most - least)) {
    for (effects::ForceRecord& record : records) {
      std::ranges::fill(record.cycle, effects::mean_of(record.cycle));
    }
  }
}

}  // namespace

std::vector<effects::ForceRecord> force_records(const std::vector<Recording>& recordings,
                                                const std::vector<Fault>& faults,
                                                const NominalModel& nominal, bool pulls_alone) {
  std::vector<effects::ForceRecord> records;
  for (const Recording& recording : recordings) {
    if (constant(recording, faults, input_column(recording)) ||
        constant(recording, faults, kOutputTensionColumn) ||
        constant(recording, faults, kTendonVelocity)) {
      continue;
    }
    effects::ForceRecord record;
    record.session = recording.session;
    record.pulls_alone = pulls_alone;
    record.time_s = recording[kTime];
    record.input_N = input_of(recording, nominal);
    if (input_column(recording) == kMotorCurrentColumn) {
      const reference::Drive drive = nominal.drive->reference();
      record.input_N_per_A =
          reference::input_tension_from_current(drive.current_offset_A + 1, drive);
    }
    record.output_N = recording[kOutputTensionColumn];
    record.output_rate_N_s = rate_of(record.time_s, record.output_N);
    record.velocity_m_s = velocity_of(recording);
    const bool rotor = recording.has(kMotorAngle) && !constant(recording, faults, kMotorAngle);
    record.rotor_known = nominal.drive && rotor;
    record.position_m = position_of(recording, record.velocity_m_s, record.rotor_known, nominal);
    if (rotor) {
      record.rotor_rad = recording[kMotorAngle];
    }
    record.reversal_m = reversals_m(record);
    record.bend_angle_rad = angle_of(recording, nominal);
    if (recording.has(kSheathTemperature)) {
      record.sheath_temperature_C = recording[kSheathTemperature];
    }
    if (recording.has(kWindingTemperature)) {
      record.winding_temperature_C = recording[kWindingTemperature];
    }
    record.cycle = cycles_of(recording);
    record.measured.assign(record.samples(), true);
    leave_out(recording, faults, record.measured);
    record.used = record.measured;
    leave_out_rest(record, recording::noise_sigma(recording[kTendonVelocity]));
    leave_out_held(record);
    if (std::ranges::count(record.used, true) > 0) {
      records.push_back(std::move(record));
    }
  }
  leave_out_uncounted_cycles(records);
  take_means_of_short_sessions(records);
  leave_out_even(records, &effects::ForceRecord::sheath_temperature_C);
  leave_out_even(records, &effects::ForceRecord::winding_temperature_C);
  return records;
}

}  // namespace host_sim::diagnose
