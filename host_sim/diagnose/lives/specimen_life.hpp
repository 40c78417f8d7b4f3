#pragma once

#include <span>
#include <vector>

#include "host_sim/diagnose/lives/life_sample.hpp"
#include "host_sim/diagnose/lives/life_settings.hpp"

namespace host_sim::diagnose::lives {

/// Damage D that a specimen has when its life is a unit of strength, in logarithms: it fails as its
/// strength w, Weibull distributed with scale 1, is D.
struct Damage {
  double ln = 0;       ///< ln D
  double ln_rate = 0;  ///< ln of dD/dn in the last block
};

struct LoadedBlock {
  double ln_life = 0;  ///< ln alpha; infinite where the load does no damage
  double cycles = 0;
};

/// Miner's sum where `sequence_exponent` is 0. Else by Manson and Halford: a share x of life in one
/// block counts as x^((N_before/N)^q) in the next, and D is the strength at which it reaches 1.
/// @pre at least one block
Damage damage_of(std::span<const LoadedBlock> blocks, double sequence_exponent);

/// What a model says alike for all specimens.
struct LifeFrame {
  struct Limit {
    double limit_N = 0;
    double ln_weight = 0;
  };
  double ln_centre_N = 0;     ///< centre_ln_N()
  double ln_scale = 0;        ///< ln A: ln alpha is ln_scale - gamma ln(T - limit)
  std::vector<Limit> limits;  ///< that a specimen may have
};
LifeFrame frame_of(const LifeSample& sample, const LifeSettings& settings);

/// What is known of the life of one specimen, before the draw that its lot shares.
class SpecimenLife {
 public:
  SpecimenLife(const LifeSample& sample, const LifeSample::Specimen& specimen,
               const LifeSettings& settings, const LifeFrame& frame);

  /// ln of the probability to survive its cycles, where its life is longer by exp(shift).
  [[nodiscard]] double log_survival(double shift) const;
  /// ln of its part of the likelihood: density of a failure per cycle, or survival.
  [[nodiscard]] double log_likelihood(double shift) const;

  /// ln of the probability to survive, and of the hazard.
  struct Risk {
    double log_survival = 0, ln_hazard = 0;

    /// ln of the density, or of the survival.
    [[nodiscard]] double log(bool density) const {
      return density ? log_survival + ln_hazard : log_survival;
    }
  };

  /// beta of this specimen, and ln D at the median of what is random.
  [[nodiscard]] double shape() const { return shape_; }
  [[nodiscard]] double ln_damage() const;
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  struct Case {
    Damage damage;
    double weight = 1;
    double rate_of_damage = 0;  ///< (dD/dn)/D
  };
  void add_cases(const LifeSample& sample, const LifeSample::Specimen& specimen,
                 const LifeSettings& settings, const LifeFrame& frame);
  [[nodiscard]] Risk first_risk(const Damage& damage, double shift) const;
  [[nodiscard]] Risk second_risk() const;
  [[nodiscard]] double log_of(const Damage& damage, double shift, bool density) const;
  [[nodiscard]] double log_mean(double shift, bool density) const;
  [[nodiscard]] double log_mixed(double shift, bool density) const;

  std::vector<Case> cases_;  ///< one, or one for each node of the limit
  Damage second_;
  bool has_second_ = false, competes_ = true;
  double ln_first_share_ = 0, ln_second_share_ = 0;  ///< where the second does not compete
  double shape_ = 1, ln_shape_ = 0;
  double second_shape_ = 1, ln_second_shape_ = 0;
  double ln_strong_ = 0, ln_weak_ = 0, weak_shift_ = 0;
  bool has_weak_ = false, lognormal_ = false;
  bool failed_ = true;
};

/// ln(exp(one) + exp(other)).
double log_sum(double one, double other);

}  // namespace host_sim::diagnose::lives
