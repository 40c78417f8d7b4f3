#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/diagnose/lives/fit.hpp"
#include "host_sim/diagnose/lives/life_sample.hpp"
#include "host_sim/effects/life_effect.hpp"

namespace host_sim::diagnose::lives {

/// Columns over specimens in the metric of their information, once A and gamma are refitted.
class LifeProjection {
 public:
  /// @param ln_tension of each specimen
  /// @param weights information of each specimen on its ln alpha
  LifeProjection(const Eigen::VectorXd& ln_tension, const Eigen::VectorXd& weights);

  /// Each column in units of the standard deviation of its specimens.
  [[nodiscard]] Eigen::MatrixXd scaled(const Eigen::MatrixXd& columns) const;
  /// The same, less what A and gamma take of it.
  [[nodiscard]] Eigen::MatrixXd left(const Eigen::MatrixXd& columns) const;

 private:
  Eigen::VectorXd roots_;
  Eigen::MatrixXd base_;  ///< orthonormal, of A and gamma
};

/// Root of the share of the energy of `column` that is in the space of `others`: |cos| for one.
double imitated(const Eigen::VectorXd& column, const Eigen::MatrixXd& others);

/// What a campaign of lives can show of one effect.
struct LifeEffectAudit {
  const effects::LifeEffect* effect = nullptr;
  /// Root of the share of its energy that is left once A and gamma are refitted, 0 .. 1, for the
  /// shape that is shown best.
  double share = 0;
  double sigmas = 0;  ///< standard deviations that it makes at the bounds of physics
  std::string why;    ///< it is invisible; empty where it is not

  [[nodiscard]] bool visible() const { return why.empty(); }
};

struct LifeAudit {
  static constexpr double kLeastShare = 0.05;
  static constexpr double kLeastSigmas = 1;
  static constexpr double kSameCosine = 0.9;

  std::vector<LifeEffectAudit> effects;  ///< in order of life_effects(), those that take part
  /// Ids of visible effects that this campaign cannot distinguish, two or more each.
  std::vector<std::vector<std::string>> equivalent;

  [[nodiscard]] std::vector<std::string> visible() const;
};

/// An effect is seen through its column on ln N, or through the specimens that share a
/// draw; each specimen weighs beta^2 times its probability to fail, its information on ln alpha.
/// @param specimens those of `sample`, in its order
/// @param without ids of effects that are taken out of the catalogue
LifeAudit audit_lives(const LifeSample& sample, const std::vector<Campaign::Specimen>& specimens,
                      const NominalFit& nominal, std::span<const std::string> without = {});

}  // namespace host_sim::diagnose::lives
