#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace host_sim {

/// Input tension over time, reduced to one band per bucket of neighbouring samples.
/// The three vectors have the same length; `time_s` never falls. With one sample a bucket the low
/// and the high value are equal and the data are the samples themselves.
struct Envelope {
  std::vector<double> time_s;  ///< middle of each bucket
  std::vector<double> low_N;   ///< exact minimum of each bucket
  std::vector<double> high_N;  ///< exact maximum of each bucket
  std::uint64_t samples_per_bucket = 1;
  std::vector<std::size_t> gaps;  ///< buckets before which samples are missing
};

/// Input and output tension in one or two cycles; none where the profile has no output tension. The
/// three vectors have the same length.
struct Loop {
  std::vector<double> time_s;
  std::vector<double> input_N;
  std::vector<double> output_N;
};

struct TurningPoint {
  double time_s = 0;
  double tension_N = 0;
};

/// Turning points in order of time. Fewer points than `total` mean that the list was thinned.
struct TurningPoints {
  std::vector<TurningPoint> points;
  std::uint64_t total = 0;
};

/// Counted cycles by their range and mean. Class (r, m) is element `r * means + m`; it covers
/// ranges from `r * range_step_N` and means from `mean_min_N + m * mean_step_N`, each one step
/// wide. No classes at all means that no cycle was counted.
struct RangeMeanMatrix {
  double range_step_N = 0;
  double mean_min_N = 0;
  double mean_step_N = 0;
  std::size_t ranges = 0;
  std::size_t means = 0;
  std::vector<double> count;   ///< cycles, halves counting 0.5; length ranges * means
  std::vector<double> damage;  ///< Miner's sum, dimensionless; length ranges * means
};

/// Damage read over time, closed cycles and open residue together; both vectors have equal length.
struct Trajectory {
  std::vector<double> time_s;
  std::vector<double> damage;
};

struct CycleCounts {
  std::uint64_t closed = 0;
  std::uint64_t open_half = 0;
};

/// Miner's sum, dimensionless; 1 is the characteristic life at which 63.2 % of wires have broken.
struct DamageSplit {
  double closed = 0;
  double open = 0;
  double total = 0;
};

/// Repeats of the profile until a wire breaks; infinite where the profile does no damage.
struct RepeatsTo {
  double B10 = 0;
  double B50 = 0;
  double mean = 0;
  double B90 = 0;
};

/// A number with the interval of the fit, where the model has one.
struct Estimate {
  double value = 0;
  std::optional<std::array<double, 2>> interval;
};

/// Life given survival, in repeats of a profile after its first pass began: unlike B10 of the whole
/// life, which the wire may have outlived.
struct GivenSurvival {
  double used = 0;
  Estimate to_10;  ///< repeats until it has broken with 10 % probability
  Estimate to_50;
  Estimate to_90;
  struct Risk {
    std::string horizon;
    double repeats = 0;  ///< that it stands for
    Estimate probability;
  };
  std::optional<Risk> risk;  ///< of a break within the horizon
  double level = 0;          ///< of the intervals; 0 where there are none
};

/// Probability over repeats of a profile that a wire, whole before the first one, has broken; all
/// vectors have equal length.
struct BreakCurve {
  std::vector<double> repeats;
  std::vector<Estimate> broken;    ///< of this wire, 0..1
  std::vector<double> broken_new;  ///< of a new one
};

/// A wire shall last until a date.
struct AskedUntil {
  std::string date;          ///< YYYY-MM-DD
  double days = 0;           ///< until then, above 0
  double hours_per_day = 0;  ///< of operation as in the profile
  double risk = 0;           ///< of a break until then that is accepted, above 0 and below 1

  [[nodiscard]] double hours() const { return days * hours_per_day; }
};

/// What lets it last: less tension or a slower pace, with the other as it is.
struct UntilDate {
  AskedUntil asked;
  double used = 0;        ///< damage before
  double repeats = 0;     ///< of the profile until the date
  bool reachable = true;  ///< false where no tension with which the wire still pulls is low enough
  double hours_to_risk = 0;  ///< as it is, until the accepted risk; infinite without damage
  double risk_as_it_is = 0;  ///< at the date
  double peak_tension_N = 0;
  double highest_tension_N = 0;  ///< peak of the profile, scaled as a whole; the ultimate at most
  double pace = 1;               ///< cycles in a time, relative to the profile's
  /// With the lower of peak_tension_N and highest_tension_N, in double precision.
  double risk_with = 0;

  [[nodiscard]] bool lasts_as_it_is() const { return hours_to_risk >= asked.hours(); }
  /// Shares of the peak and of the cycles, 0 .. 1.
  [[nodiscard]] double tension_given_up() const {
    return std::max(0.0, 1 - highest_tension_N / peak_tension_N);
  }
  [[nodiscard]] double cycles_given_up() const { return 1 - pace; }
  /// Life to the accepted risk, relative to that as it is; 1 at least.
  [[nodiscard]] double life_gained() const { return std::max(1.0, asked.hours() / hours_to_risk); }
};

struct ModelConstant {
  std::string name;
  double value = 0;
  std::string unit;  ///< empty for a pure number
};

/// Everything that the page of one replay shows. Texts are UTF-8 and need no escaping.
struct ReplayReport {
  std::string profile_name;
  std::string input_kind;  ///< in words, for example "motor current"
  std::string model_name;
  std::string model_digest;
  std::string program_version;

  std::uint64_t samples = 0;
  std::uint64_t gaps = 0;
  std::uint64_t missing_samples = 0;  ///< in them
  double duration_s = 0;
  CycleCounts cycles;
  DamageSplit damage;            ///< by the fixed-point estimator
  DamageSplit reference_damage;  ///< by the double-precision reference
  double relative_error = 0;     ///< of damage.total against the reference
  double equivalent_effective_tension_N = 0;
  double survival_probability = 1;  ///< after one pass, 0..1
  RepeatsTo repeats_to;
  std::optional<GivenSurvival> given_survival;  ///< where it was asked for
  BreakCurve break_curve;                       ///< of that wire
  std::optional<UntilDate> until_date;          ///< where it was asked for
  std::vector<std::string> flags;     ///< names as in lifemodel::Flag; empty when nothing happened
  std::vector<std::string> warnings;  ///< sentences for people, shown after the flags

  double peak_ratio = 0;                 ///< highest tension by its size, of the ultimate one
  std::array<std::uint32_t, 3> above{};  ///< excursions above 50, 70 and 90 % of it
  double minimum_tension_N = 0;          ///< 0: not watched
  double below_minimum_s = 0;            ///< time below it
  std::uint32_t slack_events = 0;
  bool broken = false;
  bool motion = false;             ///< slack and breaks were watched
  std::vector<std::string> found;  ///< slack and breaks with time and line, as sentences

  Envelope tension;
  TurningPoints turning_points;
  Loop loop;
  RangeMeanMatrix range_mean;
  Trajectory trajectory;

  std::vector<ModelConstant> model_constants;
  double weibull_shape = 1;
  double ultimate_tension_N = 0;
  double hysteresis_N = 0;
};

}  // namespace host_sim
