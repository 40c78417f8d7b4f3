#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host_sim/diagnose/lives/life_sample.hpp"

namespace host_sim::diagnose::lives {

/// Standard deviation of ln N of a Weibull life, times its shape: pi / sqrt(6).
inline constexpr double kLogLifeSd = 1.2825498301618641;

/// All that a model of lives says: the nominal law, and each departure from it at its neutral value
/// unless a term sets it. ln alpha of a block is
///   ln_life_at_centre - exponent (ln(T - S) - ln(T_c - S)) + what shifts it,
/// with T the tension of the law of mean stress, S the endurance limit, T_c the centre.
struct LifeSettings {
  double ln_life_at_centre = 0;  ///< in cycles
  double exponent = 1;           ///< gamma
  double shape = 1;              ///< beta

  std::optional<double> walker_exponent;  ///< in place of Gerber; 0 is Goodman
  double bending_N = 0;                   ///< times the ratio of wire to bend joins T_a
  bool bending_from_zero = false;         ///< and T_m: the bending goes from 0 and back
  double limit_N = 0;                     ///< S, the median over specimens
  double limit_log_sd = 0;
  double sequence_exponent = 0;  ///< of Manson and Halford; 0 is Miner
  double ageing_1_day = 0;
  double lot_log_sd = 0;

  /// A second Weibull that competes with the first in each specimen, or that a share of them has in
  /// place of the first: ln alpha_2 = ln alpha + log_life_shift + steepness |ln T - ln T_end| from
  /// the end of the levels that it reaches from.
  struct SecondMode {
    double share = 0;  ///< of the specimens; 0 where it competes in each
    double log_life_shift = 0;
    double shape = 1;
    double steepness = 0;  ///< 0 or above: how fast it fades away from that end
    std::size_t first_level = 0, last_level = 0;
    double end_N = 1;
  };
  std::optional<SecondMode> second_mode;

  // What no effect of the catalogue says.
  double group_log_sd = 0;
  double weak_share = 0;  ///< of specimens that live only a part of their life
  double weak_life_left = 1;
  bool lognormal = false;                      ///< with the median and scatter of the Weibull
  std::vector<double> load_shift;              ///< of ln alpha; empty or one for each load
  std::vector<double> level_log_shape;         ///< of ln beta; empty or one for each level
  double day_shift = 0;                        ///< of ln alpha for each day
  double falling_shift = 0, rising_shift = 0;  ///< of ln alpha in blocks, by how the load went
};

/// Fully reversed tension that does the damage of a block, before any endurance limit: Gerber's,
/// or that of Walker, T_max^(1-w) T_a^w, or of Goodman, T_a/(1 - T_m/T_u); T_a with the bending,
/// and T_m where the bending goes from zero.
double damaging_N(const LifeSample& sample, const LifeSample::Block& block,
                  const LifeSettings& settings);

/// Mean of its logarithm over the last blocks of LifeSample::reference: what ln_life_at_centre is
/// for.
double centre_ln_N(const LifeSample& sample, const LifeSettings& settings);

}  // namespace host_sim::diagnose::lives
