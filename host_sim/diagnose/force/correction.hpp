#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host_sim/diagnose/force/force_covariates.hpp"
#include "host_sim/diagnose/force/force_fit.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim::diagnose {

/// A force that is added to the input force of a model, linear between knots of one covariate and
/// constant beyond them. It has no cause.
struct ForceTable {
  std::vector<double> knots;
  std::vector<double> pulling_N, letting_go_N;  ///< at each knot, while the motion goes either way

  [[nodiscard]] double at_N(double value, bool letting_go) const;
};

/// What a model leaves, as a table, and what sessions that no fit saw make of it.
struct ForceCorrection {
  std::size_t covariate = 0;  ///< its place in kEmpiricalCovariates
  ForceTable table;
  std::vector<std::vector<double>> held_N;  ///< residuals of each record that are left
};

/// The table of least error on sessions that neither the model nor the table was fitted to, of all
/// covariates and up to kMostKnots knots; none where it does not gain on them.
/// @param fit whose residuals on the whole are what the table is written from
/// @param held_N residuals of the model alone, as ForceData::held_out
/// @param position_known whether the model is evaluated where the position is known
std::optional<ForceCorrection> correction_of(const ForceData& data, const ForceFit& fit,
                                             const std::vector<std::vector<double>>& held_N,
                                             std::span<const ForceCovariate> covariates,
                                             bool position_known);

/// [extension.empirical] of it, for a model whose input force has this gain.
Extension written_correction(const ForceCorrection& correction, double gain);

}  // namespace host_sim::diagnose
