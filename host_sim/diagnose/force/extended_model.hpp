#pragma once

#include <optional>
#include <vector>

#include "host_sim/diagnose/force/correction.hpp"
#include "host_sim/diagnose/force/force_search.hpp"
#include "host_sim/reference/constants.hpp"

namespace host_sim::diagnose {

/// A model as it is judged or as it is written.
struct ExtendedModel {
  ForceFit fit;
  std::vector<std::vector<double>> held_N;  ///< residuals on sessions that the fit never saw
  std::optional<ForceCorrection> correction = std::nullopt;
};

/// What models make of the records of a search.
class ModelExtension {
 public:
  ModelExtension(const ForceData& data, const ForceSearch& search)
      : data_(data), search_(search), covariates_(search.covariates()) {}

  /// With its correction, where that gains on sessions that nothing was fitted to.
  [[nodiscard]] ExtendedModel corrected(ExtendedModel model) const;

  /// What a file can hold of a model: another law in the place of one that none holds, of the same
  /// effect or of one that does as well; else the model without it.
  [[nodiscard]] ExtendedModel written(const ExtendedModel& model) const;

  /// Residuals of the fit to all sessions, by record and sample.
  [[nodiscard]] std::vector<std::vector<double>> left_N(const ExtendedModel& model) const;

  /// Root mean square error of the output force that this is, sample by sample.
  [[nodiscard]] double output_rmse_N(const ExtendedModel& model) const;

  /// Damage by the nominal model over that by another, geometric mean over records.
  [[nodiscard]] double damage_ratio(const ExtendedModel& model,
                                    const reference::Constants& constants) const;

 private:
  [[nodiscard]] bool rotor_known() const;
  [[nodiscard]] bool has_table(effects::ForceTerm term) const;
  [[nodiscard]] bool is_writable(const ForceFit& model, std::size_t place) const;
  [[nodiscard]] ForceFit in_a_written_model(const ForceFit& model, std::size_t place) const;
  [[nodiscard]] double added_N(const ExtendedModel& model, std::size_t record, std::size_t i) const;

  const ForceData& data_;
  const ForceSearch& search_;
  const std::vector<ForceCovariate>& covariates_;
};

/// Damage of a tension over time, counted whole.
double damage_of(std::span<const double> tension_N, const reference::Constants& constants);

/// The friction coefficient that a written model has beside these tables, for which
/// [extension.friction_load] is relative to 50 N.
double written_friction(double friction, std::span<const Extension> extensions,
                        const effects::ForceScales& scales);

}  // namespace host_sim::diagnose
