#include "host_sim/effects/tension/force_record.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace host_sim::effects {
namespace {

constexpr double kUsualTurnOver = 0.05;  ///< of the scale of speed

double quantile(std::vector<double>& values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

std::vector<double> poses_of(std::span<const ForceRecord> records) {
  constexpr double kSame_rad = std::numbers::pi / 180;
  std::vector<double> means_rad;
  for (const ForceRecord& record : records) {
    if (record.samples() > 0) {
      means_rad.push_back(mean_of(record.bend_angle_rad));
    }
  }
  std::ranges::sort(means_rad);
  std::vector<double> poses_rad;
  double last_rad = 0;
  for (const double mean_rad : means_rad) {
    if (poses_rad.empty() || mean_rad - last_rad > kSame_rad) {
      poses_rad.push_back(mean_rad);
    }
    last_rad = mean_rad;
  }
  return poses_rad;
}

std::size_t nearest(const std::vector<double>& poses_rad, double bend_angle_rad) {
  const auto off = [&](double pose_rad) { return std::abs(pose_rad - bend_angle_rad); };
  return static_cast<std::size_t>(std::ranges::min_element(poses_rad, {}, off) - poses_rad.begin());
}

/// Where a time lies between two samples.
struct Place {
  std::size_t before = 0;
  double share = 0;  ///< of the way to the next
};

/// Of each sample's time and more; beyond the ends as there.
std::vector<Place> places_at(const std::vector<double>& time_s, double later_s) {
  std::vector<Place> places;
  std::size_t before = 0;
  for (const double own_s : time_s) {
    const double at_s = own_s + later_s;
    while (before + 2 < time_s.size() && time_s[before + 1] < at_s) {
      ++before;
    }
    const double share = (at_s - time_s[before]) / (time_s[before + 1] - time_s[before]);
    places.push_back({before, std::clamp(share, 0.0, 1.0)});
  }
  return places;
}

/// On lines between samples.
std::vector<double> read_at(const std::vector<Place>& places, const std::vector<double>& values) {
  std::vector<double> read;
  read.reserve(places.size());
  for (const Place& place : places) {
    read.push_back(std::lerp(values[place.before], values[place.before + 1], place.share));
  }
  return read;
}

/// Output forces at other times, on cubics by their rates: samples are far apart for fast ones.
std::vector<double> forces_at(const std::vector<Place>& places, const ForceRecord& record) {
  std::vector<double> read_N;
  read_N.reserve(places.size());
  for (const auto& [before, share] : places) {
    const double step_s = record.time_s[before + 1] - record.time_s[before];
    const double left = 1 - share;
    read_N.push_back(
        left * left * (1 + 2 * share) * record.output_N[before] +
        share * share * (1 + 2 * left) * record.output_N[before + 1] +
        share * left * step_s *
            (left * record.output_rate_N_s[before] - share * record.output_rate_N_s[before + 1]));
  }
  return read_N;
}

/// Two equal first-order lags one after the other, exact for a value that stays until it steps.
class LateStep {
 public:
  explicit LateStep(double late_s) : each_s_(late_s / 2) {}

  void follow(double value, double for_s) {
    const double first = first_ - value;
    const double second = second_ - value;
    const double left = std::exp(-for_s / each_s_);
    first_ = value + first * left;
    second_ = value + (second + first * for_s / each_s_) * left;
  }
  void begin(double value) { first_ = second_ = value; }
  [[nodiscard]] double value() const { return second_; }

 private:
  double each_s_;
  double first_ = 0;
  double second_ = 0;
};

/// Whether each sample moves: faster than by one step of what it was read in, or just before that
/// and the same way.
std::vector<bool> moving(const std::vector<double>& velocity_m_s) {
  constexpr double kOneStep = 1.5;
  constexpr double kMost = 0.02;  // of the largest speed: more is no step
  double step_m_s = HUGE_VAL;
  double most_m_s = 0;
  for (const double value_m_s : velocity_m_s) {
    step_m_s = value_m_s != 0 ? std::min(step_m_s, std::abs(value_m_s)) : step_m_s;
    most_m_s = std::max(most_m_s, std::abs(value_m_s));
  }
  const double least_m_s = std::min(kOneStep * step_m_s, kMost * most_m_s);
  std::vector<bool> moves(velocity_m_s.size());
  for (std::size_t i = moves.size(); i-- > 0;) {
    const bool sets_in =
        i + 1 < moves.size() && moves[i + 1] && velocity_m_s[i] * velocity_m_s[i + 1] > 0;
    moves[i] = sets_in || std::abs(velocity_m_s[i]) > least_m_s;
  }
  return moves;
}

/// How far friction is turned over so much later. It steps where the motion turns, on the line
/// between two samples, and what does not move stays turned over.
void turn_later(const Motion& motion, double late_s, std::vector<double>& turned) {
  const std::vector<bool> moves = moving(motion.velocity_m_s);
  LateStep late(late_s);
  double before = turned.empty() ? 0 : turned.front();
  late.begin(before);
  for (std::size_t i = 1; i < turned.size(); ++i) {
    const double now = moves[i] ? turned[i] : before;
    const double step_s = motion.time_s[i] - motion.time_s[i - 1];
    const double before_m_s = motion.velocity_m_s[i - 1];
    const double now_m_s = motion.velocity_m_s[i];
    constexpr double kMiddle = 0.5;
    const double share = before_m_s * now_m_s < 0 ? before_m_s / (before_m_s - now_m_s) : kMiddle;
    late.follow(before, share * step_s);
    late.follow(now, (1 - share) * step_s);
    before = now;
    turned[i] = late.value();
  }
}

template <typename T>
void keep(std::vector<T>& values, const std::vector<std::size_t>& samples) {
  if (values.empty()) {
    return;
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    values[i] = values[samples[i]];
  }
  values.resize(samples.size());
}

/// Of all places since the sample that is kept before one, the farthest beyond both; else its own.
double reversal_m(const ForceRecord& record, std::size_t before, std::size_t at) {
  const auto [low_m, high_m] = std::minmax(record.position_m[before], record.position_m[at]);
  double turned_m = record.position_m[at];
  double farthest_m = 0;
  for (std::size_t i = before + 1; i <= at; ++i) {
    for (const double place_m : {record.reversal_m[i], record.position_m[i]}) {
      const double beyond_m = std::max(place_m - high_m, low_m - place_m);
      if (beyond_m > farthest_m) {
        farthest_m = beyond_m;
        turned_m = place_m;
      }
    }
  }
  return turned_m;
}

}  // namespace

void keep(ForceRecord& record, const std::vector<std::size_t>& samples) {
  for (std::size_t i = 1; i < samples.size(); ++i) {
    record.reversal_m[samples[i]] = reversal_m(record, samples[i - 1], samples[i]);
  }
  for (auto* values : {&record.time_s, &record.input_N, &record.output_N, &record.output_rate_N_s,
                       &record.velocity_m_s, &record.position_m, &record.reversal_m,
                       &record.bend_angle_rad, &record.sheath_temperature_C,
                       &record.winding_temperature_C, &record.rotor_rad, &record.cycle}) {
    keep(*values, samples);
  }
  keep(record.measured, samples);
  keep(record.used, samples);
}

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

ForceScales scales_of(std::span<const ForceRecord> records) {
  std::vector<double> speeds;
  std::vector<double> positions;
  double square_N2 = 0;
  double input_N2 = 0;
  double cycles = 1;
  double duration_s = 0;
  for (const ForceRecord& record : records) {
    duration_s += record.samples() == 0 ? 0 : record.time_s.back() - record.time_s.front();
    for (std::size_t i = 0; i < record.samples(); ++i) {
      speeds.push_back(std::abs(record.velocity_m_s[i]));
      positions.push_back(record.position_m[i]);
      square_N2 += record.output_N[i] * record.output_N[i];
      input_N2 += record.input_N[i] * record.input_N[i];
    }
    if (!record.cycle.empty()) {
      cycles = std::max(cycles, record.cycle.back());
    }
  }
  constexpr double kLeast = 1e-9;
  if (speeds.empty()) {
    return {.speed_m_s = kLeast,
            .stroke_m = kLeast,
            .force_N = kLeast,
            .turn_over_m_s = kLeast,
            .cycles = cycles,
            .poses_rad = {}};
  }
  const double low_m = quantile(positions, 0.01);
  const double high_m = quantile(positions, 0.99);
  const double speed_m_s = std::max(quantile(speeds, 0.9), kLeast);
  return {.speed_m_s = speed_m_s,
          .stroke_m = std::max(high_m - low_m, kLeast),
          .position_m = (high_m + low_m) / 2,
          .force_N = std::max(std::sqrt(square_N2 / static_cast<double>(speeds.size())), kLeast),
          .input_N = std::sqrt(input_N2 / static_cast<double>(speeds.size())),
          .turn_over_m_s = kUsualTurnOver * speed_m_s,
          .step_s = duration_s / static_cast<double>(speeds.size()),
          .cycles = cycles,
          .poses_rad = poses_of(records)};
}

std::vector<double> reversals_m(const ForceRecord& record) {
  std::vector<double> reversals = record.position_m;
  for (std::size_t i = 1; i < reversals.size(); ++i) {
    const double before_m = record.position_m[i - 1];
    const double before_m_s = record.velocity_m_s[i - 1];
    const double after_m_s = record.velocity_m_s[i];
    if (before_m_s * after_m_s < 0) {
      const double rising_s =
          (record.time_s[i] - record.time_s[i - 1]) * before_m_s / (before_m_s - after_m_s);
      const double turned_m = before_m + before_m_s * rising_s / 2;
      const auto [low_m, high_m] = std::minmax({before_m, turned_m, reversals[i]});
      reversals[i] = before_m_s > 0 ? high_m : low_m;
    }
  }
  return reversals;
}

std::vector<bool> next_to_turns(const ForceRecord& record) {
  std::vector<bool> next(record.samples());
  for (std::size_t i = 1; i < next.size(); ++i) {
    next[i] = record.velocity_m_s[i] * record.velocity_m_s[i - 1] < 0;
    next[i - 1] = next[i - 1] || next[i];
  }
  return next;
}

Kinematics kinematics_of(const ForceRecord& record, const ForceScales& scales) {
  Kinematics kinematics;
  kinematics.turned_over = turned_over(record, scales);
  const auto turn_of = [&](double position_m) {
    return 2 * std::numbers::pi * (position_m - scales.position_m) / scales.wavelength_m();
  };
  if (record.samples() > 0) {
    const auto [low_m, high_m] = std::ranges::minmax(record.position_m);
    kinematics.middle_sine = std::sin(turn_of((low_m + high_m) / 2));
    kinematics.middle_cosine = std::cos(turn_of((low_m + high_m) / 2));
  }
  for (std::size_t i = 0; i < record.samples(); ++i) {
    const double turn = turn_of(record.position_m[i]);
    kinematics.place_sine.push_back(std::sin(turn));
    kinematics.place_cosine.push_back(std::cos(turn));
    kinematics.pose.push_back(nearest(scales.poses_rad, record.bend_angle_rad[i]));
  }
  return kinematics;
}

std::vector<double> turned_over(const ForceRecord& record, const ForceScales& scales) {
  const auto turned_at = [&](std::vector<double> velocity_m_s) {
    for (double& value : velocity_m_s) {
      value = std::tanh(value / scales.turn_over_m_s);
    }
    return velocity_m_s;
  };
  if (scales.forces_late_s == 0) {
    return turned_at(record.velocity_m_s);
  }
  const Motion motion = record.motion ? *record.motion : Motion{record.time_s, record.velocity_m_s};
  std::vector<double> turned = turned_at(motion.velocity_m_s);
  turn_later(motion, scales.forces_late_s, turned);
  for (std::size_t i = 0; i < record.samples(); ++i) {
    turned[i] = turned[i * record.motion_step];
  }
  turned.resize(record.samples());
  return turned;
}

LaterRecord read_later(const ForceRecord& record, const Kinematics& kinematics,
                       const ForceScales& scales, double later_s) {
  const std::vector<Place> places = places_at(record.time_s, later_s);
  LaterRecord later{record, std::nullopt};
  ForceRecord& read = later.record;
  read.output_N = forces_at(places, record);
  if (later_s > 0) {
    return later;
  }
  Kinematics& moved = later.kinematics.emplace(kinematics);
  for (auto* const channel : {&read.output_rate_N_s, &read.position_m, &read.velocity_m_s,
                              &moved.place_sine, &moved.place_cosine}) {
    *channel = read_at(places, *channel);
  }
  read.reversal_m = reversals_m(read);
  moved.turned_over = scales.forces_late_s > 0 ? read_at(places, kinematics.turned_over)
                                               : turned_over(read, scales);
  return later;
}

}  // namespace host_sim::effects
