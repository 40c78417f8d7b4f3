#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/life_law/life_fit.hpp"
#include "host_sim/statistics/common_shape.hpp"
#include "host_sim/statistics/goodness_of_fit.hpp"

namespace host_sim::calibrate {

using life_law::LifeLaw;
using statistics::Interval;
using statistics::Test;

/// Below it a test rejects.
inline constexpr double kSignificance = 0.05;
inline constexpr double kConfidence = 0.95;

/// The simulated p-value where there is one, else that of the chi-square distribution.
inline double p_of(const Test& test) {
  return std::isnan(test.p_simulated) ? test.p_chi_square : test.p_simulated;
}

/// Whether a test is evidence against its hypothesis; a p-value that was not computed is none.
inline bool rejected(const Test& test) {
  return p_of(test) < kSignificance;
}

/// Why there is no fit, in a few words; empty where there is one.
std::string_view problem_name(statistics::FitProblem problem);

/// One level with its own fits (the paper's Tables 3 and 4).
struct LevelResult {
  Campaign::Load load;
  Campaign::Role role = Campaign::Role::fit;
  statistics::Sample sample;
  std::vector<std::string> specimens;   ///< their names, as long as the sample
  std::array<statistics::Fit, 3> fits;  ///< by statistics::Family
  std::array<std::optional<statistics::GoodnessOfFit>, 3>
      goodness;                   ///< none where the fit has a problem or a life lies between ends
  double shape_unbiased = 0;      ///< of the Weibull fit
  double mean_life = 0;           ///< of the Weibull fit
  statistics::QuantileBand band;  ///< 95 %, of the Weibull fit; empty where it has a problem
  std::vector<statistics::PlottingPosition> positions;
  std::string left_out;  ///< why it is not in the life model; empty where it is

  [[nodiscard]] const statistics::Fit& weibull() const {
    return fits[static_cast<std::size_t>(statistics::Family::weibull)];
  }
  [[nodiscard]] std::size_t failed() const;        ///< dropped lives and those found broken too
  [[nodiscard]] std::size_t found_broken() const;  ///< at an inspection, without a known life
  [[nodiscard]] std::size_t trimmed() const;       ///< lives dropped as the lowest or highest
  [[nodiscard]] std::string name() const;          ///< "315 deg, 42.5 N", or the tension alone
};

/// The test of one level's shape against that of the others.
struct OddLevel {
  std::size_t level = 0;   ///< index into CalibrateResult::levels
  Test test;               ///< one degree of freedom
  double p_corrected = 1;  ///< for having looked at every level (Bonferroni, simulated p)
};

/// One shape for the levels of role fit: eqs. (16) - (18).
struct CommonShape {
  double value = 0;
  Interval ci95;
  double unbiased = 0;
  Test homogeneity;                     ///< over the levels of the life model
  std::optional<Test> with_all_levels;  ///< where a level was left out: the test with it
  std::vector<OddLevel> odd_levels;     ///< each level of role fit against the others
};

/// The stress-life relation.
struct StressLife {
  LifeLaw law;  ///< maximum likelihood over all specimens in the life model
  double log_likelihood = 0;
  Interval scale_ci95, exponent_ci95, shape_ci95;
  double pivot_tension_N = 0;   ///< see life_law::pivot_tension_N()
  Interval life_at_pivot_ci95;  ///< of the characteristic life there
  double shape_unbiased = 0;
  std::optional<LifeLaw> least_squares;  ///< the paper's way: in alpha, with the common shape
  double least_squares_rmse = 0;
  std::optional<Test> against_free_levels;  ///< none with two levels
  std::optional<Test> against_curvature;
  std::optional<Test> against_growing_scatter;
  Interval tested_N{1, 0};             ///< with some room beside; empty (low above high) without
  std::vector<double> band_tension_N;  ///< rising; over what was tested and all use levels
  std::vector<Interval> band_mean;     ///< 95 %, profile likelihood, of the mean life
};

/// What the model says at a load that matters.
struct UseLevel {
  std::string name;
  double effective_tension_N = 0;
  double mean = 0, b10 = 0, b50 = 0, b90 = 0;
  Interval mean_ci95, b10_ci95;
  Interval next_specimen_95;  ///< prediction interval for the life of one more specimen
};

struct ValidationResult {
  std::size_t level = 0;   ///< index into CalibrateResult::levels; nothing where in_blocks
  bool in_blocks = false;  ///< all validation specimens in blocks together, in damage for cycles
  double predicted_mean = 0;
  double measured_mean = 0;  ///< of the failures; with suspended ones, by maximum likelihood
  Interval ratio_ci95;       ///< of the true mean over the predicted one
  double p = 0;  ///< of a difference as large, with the uncertainty of the fit; two-sided
  std::size_t below_b10 = 0, inside_b10_b90 = 0, above_b90 = 0;  ///< failures known to be there
  std::string words;
};

/// Variable loading: the constant load that does the same.
struct MixResult {
  struct Part {
    double effective_tension_N = 0;
    double share = 0;  ///< of the cycles
  };
  std::string name;
  std::vector<Part> parts;
  double by_damage_N = 0;            ///< under the fitted law
  double by_average_of_lives_N = 0;  ///< the paper's section 4.3
};

struct CalibrateResult {
  std::string campaign;
  std::size_t specimens = 0, failed = 0, suspended = 0;  ///< of role fit
  std::size_t in_blocks = 0;                             ///< specimens loaded in blocks
  std::vector<LevelResult> levels;                       ///< by role, then rising tension
  std::optional<CommonShape> common_shape;               ///< none with fewer than two levels
  std::optional<StressLife> stress_life;  ///< none where it cannot be fitted: see warnings
  std::vector<UseLevel> use_levels;
  std::vector<ValidationResult> validation;
  std::vector<MixResult> mixes;
  std::uint64_t seed = 0;
  std::size_t bootstraps = 0;
  std::vector<std::string> warnings;
};

}  // namespace host_sim::calibrate
