#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/effects/effect.hpp"

namespace host_sim::effects {

/// Columns that are linear in their coefficients, for one value of the parameters that are not
/// linear.
struct Signature {
  std::vector<double> shape;                 ///< nonlinear parameters, in order; may be empty
  std::vector<std::vector<double>> columns;  ///< each as long as the specimens
};

/// The nominal life that effects change: alpha = A / T_eff^gamma (19), T_eff by Gerber (11).
struct LifeBaseline {
  double ultimate_tension_N = 0;  ///< T_u
  double ipl_scale = 0;           ///< A
  double ipl_exponent = 0;        ///< gamma
};

/// What effects on life are written in terms of. Each vector has one value for each specimen, or is
/// empty where one of them lacks it.
struct LifeCovariates {
  struct Block {
    double mean_N = 0;       ///< T_m of input tension
    double amplitude_N = 0;  ///< T_a
    double effective_N = 0;  ///< T_eff
    double cycles = 0;
    double life_cycles = 0;   ///< alpha
    double damage_share = 0;  ///< of the specimen's damage by Miner; all sum to 1
  };
  std::vector<std::vector<Block>> blocks;  ///< in order of loading; at least one a specimen
  std::vector<double> log_effective_N;     ///< ln of the constant T_eff of the same damage
  std::vector<std::size_t> level;  ///< by rising T_eff, from 0; specimens of one load share it
  std::vector<std::size_t> lot;    ///< in order of the lots' names, from 0
  std::vector<std::string> group;
  std::vector<double> days;
  std::vector<double> wire_to_bend_ratio;

  [[nodiscard]] std::size_t specimens() const { return blocks.size(); }
  [[nodiscard]] std::size_t levels() const;
  [[nodiscard]] std::size_t lots() const;
  [[nodiscard]] double lowest_effective_N() const;  ///< of all blocks
};

/// @pre T_eff above 0 in each block, as read_campaign() makes sure
LifeCovariates life_covariates_of(std::span<const Campaign::Specimen> specimens,
                                  const LifeBaseline& baseline);

/// What an effect does to the scatter of lives.
struct Scatter {
  /// What a unit of the first scatter parameter adds to the standard deviation of ln N of each
  /// specimen (in quadrature); 0 where it does not reach.
  std::vector<double> log_life_sd;
  /// Specimens with the same number have one draw in common.
  std::vector<std::size_t> shared_by;
};

/// What an effect on life does to ln N.
enum class LifeEffectKind {
  mean,     ///< moves ln N: signature() has columns
  scatter,  ///< moves no mean: scatter() alone, signature() has no columns
  both,     ///< moves ln N of the specimens that it reaches and scatters them anew
};

/// One effect of the catalogue on life, with all that is known of it: it adds to ln N of a
/// specimen, or to its scatter.
class LifeEffect {
 public:
  LifeEffect() = default;
  LifeEffect(const LifeEffect&) = delete;
  LifeEffect& operator=(const LifeEffect&) = delete;
  virtual ~LifeEffect() = default;

  [[nodiscard]] virtual std::string_view id() const = 0;
  [[nodiscard]] virtual LifeEffectKind kind() const = 0;
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
