#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/effects/life_covariates.hpp"
#include "host_sim/effects/tension_effect.hpp"

namespace host_sim::effects {

/// What an effect does to the scatter of lives.
struct Scatter {
  /// What a unit of the first scatter parameter adds to the standard deviation of ln N of each
  /// specimen (in quadrature); 0 where it does not reach.
  std::vector<double> log_life_sd;
  /// Specimens with the same number have one draw in common.
  std::vector<std::size_t> shared_by;
};

/// One effect of the catalogue on life, with all that is known of it: it adds to ln N of a
/// specimen, or to its scatter.
class LifeEffect {
 public:
  enum class Kind {
    mean,     ///< moves ln N: signature() has columns
    scatter,  ///< moves no mean: scatter() alone, signature() has no columns
    both,     ///< moves ln N of the specimens that it reaches and scatters them anew
  };

  LifeEffect() = default;
  LifeEffect(const LifeEffect&) = delete;
  LifeEffect& operator=(const LifeEffect&) = delete;
  virtual ~LifeEffect() = default;

  [[nodiscard]] virtual std::string_view id() const = 0;
  [[nodiscard]] virtual Kind kind() const = 0;
  [[nodiscard]] virtual std::string_view term() const = 0;
  [[nodiscard]] virtual std::string_view equation() const = 0;
  [[nodiscard]] virtual std::string_view life_consequence() const = 0;
  /// Those whose columns are linear first, in order of the columns; then the one of the scatter,
  /// where there is one; then those of the shape.
  [[nodiscard]] virtual std::span<const Parameter> parameters() const = 0;
  [[nodiscard]] virtual std::span<const Separation> separations() const = 0;

  /// Empty where `covariates` hold what it needs, else what is missing, in words.
  [[nodiscard]] virtual std::string missing(const LifeCovariates& covariates) const = 0;

  /// Values of Signature::shape to try; one empty one where all is linear.
  [[nodiscard]] virtual std::vector<std::vector<double>> shapes() const = 0;

  /// What ln N of each specimen changes by for each unit of each linear parameter. `shape` is one
  /// of shapes(). @pre missing() is empty
  [[nodiscard]] virtual Signature signature(const LifeCovariates& covariates,
                                            const LifeBaseline& baseline,
                                            std::span<const double> shape) const = 0;

  /// Empty vectors where kind() is mean. @pre missing() is empty
  [[nodiscard]] virtual Scatter scatter(const LifeCovariates& covariates,
                                        const LifeBaseline& baseline,
                                        std::span<const double> shape) const = 0;
};

/// All effects on life, in order of their ids.
std::span<const std::unique_ptr<LifeEffect>> life_effects();

}  // namespace host_sim::effects
