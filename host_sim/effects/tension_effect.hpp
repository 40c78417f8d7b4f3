#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/recording/covariates.hpp"

namespace host_sim::effects {

/// Symbols as in r = ln T_out - ln T_in + mu phi s: what an effect adds to r.
struct Baseline {
  double friction_coefficient = 0;  ///< mu
  double sheath_reference_C = 20;   ///< where the temperature term is zero
  double winding_reference_C = 20;
  std::vector<double> poses_rad;  ///< bend angles of the campaign, rising; none: one pose

  friend bool operator==(const Baseline&, const Baseline&) = default;
};

struct Parameter {
  std::string_view name;  ///< with its unit as suffix
  std::string_view unit;
  double minimum = 0;  ///< bounds of physics
  double maximum = 0;
  double typical = 0;  ///< magnitude of a usual effect
  /// Of a parameter of shape: the linear one before it only says how far this one is off, to first
  /// order, so that their product is what is known.
  bool scaled_by_share = false;
  bool off_line = false;  ///< no controller evaluates it; an extension may leave it out as zero
};

/// How one effect is distinguished from another.
struct Separation {
  std::string_view other;       ///< id of the effect it is confounded with
  std::string_view experiment;  ///< that breaks it, as an instruction: "heat the sheath alone"
};

/// A signature: columns that are linear in their coefficients, for one value of the parameters that
/// are not linear.
struct Signature {
  std::vector<double> shape;                 ///< nonlinear parameters, in order; may be empty
  std::vector<std::vector<double>> columns;  ///< each as long as the samples
};

/// One effect of the catalogue on tension, with all that is known of it.
class TensionEffect {
 public:
  TensionEffect() = default;
  TensionEffect(const TensionEffect&) = delete;
  TensionEffect& operator=(const TensionEffect&) = delete;
  virtual ~TensionEffect() = default;

  [[nodiscard]] virtual std::string_view id() const = 0;        ///< "friction_wear"
  [[nodiscard]] virtual std::string_view term() const = 0;      ///< the field's word for it
  [[nodiscard]] virtual std::string_view equation() const = 0;  ///< of the extended model
  [[nodiscard]] virtual std::string_view life_consequence() const = 0;
  /// Those whose columns are linear first, in order of the columns, then those of Signature::shape.
  [[nodiscard]] virtual std::span<const Parameter> parameters() const = 0;
  [[nodiscard]] virtual std::span<const Separation> separations() const = 0;

  /// Whether the columns are one for each of Baseline::poses_rad. All of them then stand for
  /// parameters()[0], with a value of its own for each pose.
  [[nodiscard]] virtual bool per_pose() const { return false; }

  /// Whether it acts by what a reversal leaves for a while. Two such effects at once do not add up:
  /// one works on what the other has left.
  [[nodiscard]] virtual bool at_reversals() const { return false; }

  /// Whether all that it does to a session is to shift its gain and its friction: it shows between
  /// sessions, and not in the shape of a stroke.
  [[nodiscard]] virtual bool shifts_sessions() const { return false; }

  /// Empty where `covariates` hold what it needs, else what is missing, in words.
  [[nodiscard]] virtual std::string missing(const recording::Covariates& covariates) const = 0;

  /// Values of Signature::shape to try, a grid over the bounds; one empty one where all is linear.
  [[nodiscard]] virtual std::vector<std::vector<double>> shapes() const = 0;

  /// Whether what lies between two neighbours of shapes() is a shape too; harmonics are whole.
  [[nodiscard]] virtual bool shapes_between() const { return true; }

  /// What r changes by for each unit of each linear parameter. `shape` is one of shapes().
  [[nodiscard]] virtual Signature signature(const recording::Covariates& covariates,
                                            const Baseline& baseline,
                                            std::span<const double> shape) const = 0;
};

/// All effects on tension, in order of their ids.
std::span<const std::unique_ptr<TensionEffect>> tension_effects();

}  // namespace host_sim::effects
