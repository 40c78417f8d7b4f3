#pragma once

#include <span>
#include <string>
#include <vector>

#include "host_sim/diagnose/sessions.hpp"

namespace host_sim::diagnose {

/// Tests the residual against one covariate without a cause in mind: one column for each bin of
/// the covariate and each direction, 1 in the samples that fall there.
struct Probe {
  enum class Of {
    cycle,
    bend_angle,
    sheath_temperature,
    winding_temperature,
    speed,
    log_tension,  ///< of the geometric mean of both ends, so that no noise of one is in it
    position,
    motor_angle,  ///< within a turn
    travel,       ///< since the last reversal
    log_tension_rate,
    elapsed,  ///< since the recording began
  };
  Of of = Of::cycle;
  std::vector<double> edges;  ///< between bins, rising; one bin more than edges

  [[nodiscard]] std::size_t bins() const { return edges.size() + 1; }
  /// Bins while letting go, then bins while pulling.
  [[nodiscard]] std::size_t columns() const { return 2 * bins(); }
  /// Of each sample. @pre the covariate was recorded
  [[nodiscard]] std::vector<std::size_t> column_of(const recording::Covariates& covariates) const;
  friend bool operator==(const Probe&, const Probe&) = default;
};

/// "sheath temperature"
std::string_view name_of(Probe::Of of);
/// "C"; "1" where there is none
std::string_view unit_of(Probe::Of of);

/// Values of the covariate, empty where it was not recorded.
std::vector<double> values_of(Probe::Of of, const recording::Covariates& covariates);

/// A probe of each covariate that all sessions hold and that varies, with bins of like numbers of
/// samples.
std::vector<Probe> probes_of(std::span<const Session> sessions);

}  // namespace host_sim::diagnose
