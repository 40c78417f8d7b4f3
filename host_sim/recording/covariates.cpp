#include "host_sim/recording/covariates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

#include "hal/files/input_error.hpp"
#include "hal/files/text.hpp"
#include "host_sim/recording/motion.hpp"
#include "host_sim/recording/signal.hpp"
#include "host_sim/reference/equations.hpp"

namespace host_sim::recording {

using hal::files::in_quotes;
using hal::files::InputError;
using enum hal::files::ProfileColumnId;

namespace {

/// What the faults of its session leave of a recording. A constant channel counts as not recorded;
/// any other fault takes its samples.
struct Usable {
  Channels channels;            ///< as recorded, empty where the channel is left out
  std::vector<bool> touched;    ///< samples that a fault takes
  std::vector<Stretch> motion;  ///< over which velocity was measured without a gap
};

void mark(std::vector<bool>& samples, const Fault& fault) {
  const std::size_t end = std::min(fault.first + fault.count, samples.size());
  for (std::size_t i = std::min(fault.first, end); i < end; ++i) {
    samples[i] = true;
  }
}

std::vector<Stretch> cut_at(const std::vector<Stretch>& stretches,
                            const std::vector<bool>& begins_anew) {
  std::vector<Stretch> pieces;
  for (const Stretch& stretch : stretches) {
    for (std::size_t i = stretch.first; i < stretch.end(); ++i) {
      if (i == stretch.first || begins_anew[i]) {
        pieces.push_back({i, 0});
      }
      ++pieces.back().count;
    }
  }
  return pieces;
}

/// @param faults of any sessions; those of others do not matter
Usable usable_part(const Recording& recording, const std::vector<Fault>& faults) {
  const std::size_t samples = recording.samples();
  Usable usable{recording.channels, std::vector<bool>(samples), {}};
  std::vector<bool> no_velocity(samples);
  std::vector<bool> after_gap(samples);
  for (const Fault& fault : faults) {
    if (fault.session != recording.session) {
      continue;
    }
    if (fault.kind == Fault::Kind::constant) {
      usable.channels[fault.channel].clear();
      continue;
    }
    mark(usable.touched, fault);
    if (fault.kind == Fault::Kind::gap && fault.first < samples) {
      after_gap[fault.first] = true;
    } else if (fault.channel == kTendonVelocity) {
      mark(no_velocity, fault);
    }
  }
  if (!usable.channels[kTendonVelocity].empty()) {
    usable.motion = cut_at(stretches_of(no_velocity, false), after_gap);
  }
  return usable;
}

/// Of short strokes the settled samples are ends alone, and friction there is that of the ends.
constexpr double kLeastShare = 0.25;

}  // namespace

SettledSums::SettledSums(const Covariates& covariates) {
  double samples = 0;
  double mean_x = 0;
  double mean_y = 0;
  for (std::size_t i = 0; i < covariates.samples(); ++i) {
    if (covariates.travel_m[i] < kSettledTravel_m) {
      continue;
    }
    const double x = -covariates.bend_angle_rad[i] * covariates.direction[i];
    const double y = std::log(covariates.output_tension_N[i] / covariates.tension_in_N()[i]);
    samples += 1;
    const double off_x = x - mean_x;
    mean_x += off_x / samples;
    mean_y += (y - mean_y) / samples;
    square += off_x * (x - mean_x);
    product += off_x * (y - mean_y);
  }
  if (samples < kLeastShare * static_cast<double>(covariates.samples())) {
    square = 0;
    product = 0;
  }
}

double settled_friction(const Covariates& covariates) {
  const SettledSums sums(covariates);
  return sums.square > 0 ? sums.product / sums.square : 0;
}

namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180;
constexpr std::size_t kLeastPiece = 5;

/// To each side: within it a velocity is a cubic, and a temperature goes evenly.
constexpr double kSmoothMotion_s = 0.03;
constexpr double kSmoothHeat_s = 1;

[[noreturn]] void fail(const Recording& recording, std::string_view what,
                       std::string_view accepted) {
  throw InputError(recording.file.string(), 0, 0,
                   fmt::format("session {} {}", in_quotes(recording.session), what), accepted);
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) {
    value *= factor;
  }
  return values;
}

std::vector<double> current_tension_N(const std::vector<double>& current_A,
                                      const Model::Drive& drive) {
  const reference::Drive nominal = drive.reference();
  std::vector<double> tension_N;
  tension_N.reserve(current_A.size());
  for (const double current : current_A) {
    tension_N.push_back(reference::input_tension_from_current(current, nominal));
  }
  return tension_N;
}

std::vector<double> bend_angle_rad(const Recording& recording, const Channels& channels,
                                   const NominalModel& nominal) {
  if (!channels[kBendAngle].empty()) {
    return scaled(channels[kBendAngle], kRadPerDeg);
  }
  if (!nominal.sheath) {
    fail(recording, "has no known bend angle",
         "the column bend_angle_deg, or bend_angle_deg in [model.sheath] of campaign.toml");
  }
  return std::vector<double>(recording.samples(), nominal.sheath->bend_angle_deg * kRadPerDeg);
}

void add_current(const Recording& recording, const Channels& channels, const NominalModel& nominal,
                 Covariates& all) {
  if (channels[kMotorCurrentColumn].empty()) {
    return;
  }
  if (!nominal.drive) {
    fail(recording, "has motor_current_A, but the campaign no drive",
         "[model.drive] in campaign.toml");
  }
  all.current_A = channels[kMotorCurrentColumn];
  for (double& current : all.current_A) {
    current -= nominal.drive->current_offset_A;
  }
  all.current_tension_N = current_tension_N(channels[kMotorCurrentColumn], *nominal.drive);
}

void add_motion(const Recording& recording, const Motion& motion, Covariates& all) {
  all.direction = motion.direction;
  all.travel_m = motion.travel_m;
  for (const double reversals : motion.reversals) {
    all.cycle.push_back(recording.start_cycle + reversals / 2);
  }
}

/// A position without an origin, from the middle of its range, so that strokes of several
/// recordings lie over each other.
std::vector<double> from_middle(std::vector<double> position_m) {
  const auto [low, high] = std::ranges::minmax_element(position_m);
  const double middle_m = position_m.empty() ? 0 : std::midpoint(*low, *high);
  for (double& value_m : position_m) {
    value_m -= middle_m;
  }
  return position_m;
}

void add_position(const Channels& channels, const NominalModel& nominal, Covariates& all) {
  all.motor_angle_rad = channels[kMotorAngle];
  if (nominal.drive && !all.motor_angle_rad.empty()) {
    all.position_m =
        scaled(all.motor_angle_rad, nominal.drive->spool_radius_m() / nominal.drive->gear_ratio);
  } else {
    all.position_m = from_middle(integral(all.time_s, all.velocity_m_s));
  }
}

/// Samples of pieces that are long enough, with tensions that have a logarithm.
std::vector<Stretch> pieces_of(const Usable& usable, const Covariates& all) {
  std::vector<bool> whole(all.samples());
  for (const Stretch& stretch : usable.motion) {
    for (std::size_t i = stretch.first; i < stretch.end(); ++i) {
      const auto is_positive = [&](const std::vector<double>& values) {
        return values.empty() || values[i] > 0;
      };
      whole[i] = !usable.touched[i] && is_positive(all.input_tension_N) &&
                 is_positive(all.current_tension_N) && is_positive(all.output_tension_N);
    }
  }
  std::vector<Stretch> pieces;
  for (const Stretch& stretch : usable.motion) {
    const auto begin = whole.begin() + static_cast<std::ptrdiff_t>(stretch.first);
    const std::vector<bool> part(begin, begin + static_cast<std::ptrdiff_t>(stretch.count));
    for (const Stretch& piece : stretches_of(part, true, kLeastPiece)) {
      pieces.push_back({stretch.first + piece.first, piece.count});
    }
  }
  return pieces;
}

std::vector<std::size_t> kept_samples(const std::vector<Stretch>& pieces, const Motion& motion) {
  std::vector<std::size_t> kept;
  for (const Stretch& piece : pieces) {
    for (std::size_t i = piece.first; i < piece.end(); ++i) {
      if (motion.known[i]) {
        kept.push_back(i);
      }
    }
  }
  return kept;
}

std::vector<double> at(const std::vector<double>& values, const std::vector<std::size_t>& places) {
  std::vector<double> picked;
  if (!values.empty()) {
    picked.reserve(places.size());
    for (const std::size_t place : places) {
      picked.push_back(values[place]);
    }
  }
  return picked;
}

Covariates at(const Covariates& all, const std::vector<std::size_t>& places) {
  Covariates picked;
  for (std::vector<double> Covariates::*const member :
       {&Covariates::time_s, &Covariates::cycle, &Covariates::direction, &Covariates::velocity_m_s,
        &Covariates::bend_angle_rad, &Covariates::input_tension_N, &Covariates::current_A,
        &Covariates::current_tension_N, &Covariates::output_tension_N, &Covariates::travel_m,
        &Covariates::position_m, &Covariates::motor_angle_rad, &Covariates::log_tension_rate_1_s,
        &Covariates::log_output_rate_1_s, &Covariates::sheath_temperature_C,
        &Covariates::winding_temperature_C}) {
    picked.*member = at(all.*member, places);
  }
  return picked;
}

}  // namespace

Covariates covariates_of(const Recording& recording, const std::vector<Fault>& faults,
                         const NominalModel& nominal) {
  const Usable usable = usable_part(recording, faults);
  const Channels& channels = usable.channels;
  Covariates all;
  all.time_s = channels[kTime];
  all.velocity_m_s = channels[kTendonVelocity];
  all.input_tension_N = channels[kInputTensionColumn];
  all.output_tension_N = channels[kOutputTensionColumn];
  all.sheath_temperature_C = channels[kSheathTemperature];
  all.winding_temperature_C = channels[kWindingTemperature];
  all.bend_angle_rad = bend_angle_rad(recording, channels, nominal);
  add_current(recording, channels, nominal, all);
  if (all.velocity_m_s.empty() || all.output_tension_N.empty() || all.tension_in_N().empty()) {
    return {};
  }
  const Motion motion =
      motion_of(all.time_s, all.velocity_m_s, usable.motion, dead_band_m_s(all.velocity_m_s));
  add_motion(recording, motion, all);
  add_position(channels, nominal, all);
  const std::vector<Stretch> pieces = pieces_of(usable, all);
  all.log_tension_rate_1_s = log_rate_1_s(all.time_s, all.tension_in_N(), pieces);
  all.log_output_rate_1_s = smooth_log_rate_1_s(all.time_s, all.output_tension_N, pieces);
  all.velocity_m_s = smoothed(all.time_s, all.velocity_m_s, pieces, kSmoothMotion_s);
  for (auto* const temperature_C : {&all.sheath_temperature_C, &all.winding_temperature_C}) {
    if (!temperature_C->empty()) {
      *temperature_C = moving_mean(all.time_s, *temperature_C, pieces, kSmoothHeat_s);
    }
  }
  Covariates kept = at(all, kept_samples(pieces, motion));
  kept.settled_friction = settled_friction(kept);
  return kept;
}

}  // namespace host_sim::recording
