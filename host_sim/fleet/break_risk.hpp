#pragma once

#include <vector>

#include "host_sim/fleet/fleet_table.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim::fleet {

/// How sure a law of life is, in standard deviations: ln of the characteristic life at the pivot,
/// the exponent and ln of the shape are normal and do not depend on each other. The true
/// characteristic life at the effective tension T is exp(u) times that of the law, with
/// u = a - b ln(T / pivot).
struct LawBelief {
  double shape = 1;         ///< beta of eq. (20)
  double log_shape_sd = 0;  ///< of ln beta
  double log_life_sd = 0;   ///< of a
  double exponent_sd = 0;   ///< of b
  double pivot_tension_N = 1;

  [[nodiscard]] bool exact() const {
    return log_shape_sd == 0 && log_life_sd == 0 && exponent_sd == 0;
  }
};

/// ln(T / pivot); 0 where the tension of a tendon is not known.
double distance_from_pivot(const LawBelief& law, const Tendon& tendon);

/// A point of a standard normal variable and the share that it stands for.
struct NormalPoint {
  double z = 0;
  double weight = 1;
};

/// `2 reach + 1` points `step` apart for the mean of a smooth function: the trapezoidal rule, whose
/// error falls as exp(-2 pi^2 / step^2). One point where the deviation `sd` is 0.
std::vector<NormalPoint> normal_points(double step, int reach, double sd);

/// Factors of the rate of damage with the mean 1, lognormal with `log_sd`, and their shares.
std::vector<NormalPoint> rate_factors(double log_sd);

/// What (D / e^u)^beta grows by, u = 0, while the damage D grows from `used` by `further`.
double hazard_growth(double used, double further, double shape);

/// The risk that a tendon which is whole breaks, with what is not known of its law and of its rate.
/// That it has survived so far counts as evidence of its law: weak laws lose weight.
class BreakRisk {
 public:
  BreakRisk(const LawBelief& law, const Tendon& tendon);

  /// The probability that it breaks within so many hours of operation.
  [[nodiscard]] double within(double hours) const;

  /// The same where its survival so far were no evidence of its law.
  [[nodiscard]] double within_of_all_laws(double hours) const;

  /// Hours of operation until that probability is `risk`; infinity for a tendon that does no
  /// damage, or so little that no number holds them.
  /// @pre 0 < risk < 1
  [[nodiscard]] double hours_to(double risk) const;

  /// The probability that it breaks within so many hours with the law and the rate as they are
  /// fitted.
  [[nodiscard]] double within_at_fit(double hours) const;

 private:
  struct Shape;
  struct Law;
  /// The probability that it breaks by so much further damage, with the laws so weighed.
  [[nodiscard]] double of_further(double damage, double Law::*weight) const;

  /// A law that may be the true one.
  struct Law {
    double rate_of_hazard;  ///< exp(-beta u)
    double share;           ///< of all laws
    double weight;          ///< of it, given survival
  };
  /// All laws of one shape.
  struct Shape {
    double shape;
    std::vector<Law> laws;
  };

  double used_;
  double damage_per_h_;
  double fitted_shape_;
  std::vector<NormalPoint> rates_;
  std::vector<Shape> shapes_;
};

}  // namespace host_sim::fleet
