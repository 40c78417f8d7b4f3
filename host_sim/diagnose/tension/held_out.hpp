#pragma once

#include <span>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/tension/hypothesis.hpp"
#include "host_sim/reference/constants.hpp"

namespace host_sim::diagnose {

/// What a model makes of a session that its fit never saw.
struct SessionScore {
  double samples = 0;
  double output_square_N2 = 0;  ///< sum of (predicted - measured)^2, of T_out from T_in
  double input_square_N2 = 0;   ///< the same of T_in from T_out
  double log_density = 0;       ///< of all samples together
  double damage_error = 0;      ///< magnitude, as a share; 0 where nothing is damaged
};

/// In order of the sessions.
struct HeldOut {
  std::vector<SessionScore> sessions;

  /// Sum of one figure over the sessions.
  [[nodiscard]] double sum(double SessionScore::*figure) const;
  [[nodiscard]] double output_rmse_N() const;
  [[nodiscard]] double input_rmse_N() const;
  [[nodiscard]] double log_density() const;  ///< of a sample
};

/// The sessions are dealt into folds, each predicted by the fit of the others.
/// @pre three sessions or more
HeldOut held_out(const Evidence& evidence, std::span<const Component> model,
                 const reference::Constants& constants);

/// The nominal model, refitted, and the extended one on sessions that neither saw.
/// @pre three sessions or more
HeldOutGain measure_gain(const Evidence& evidence, std::span<const Component> model,
                         const reference::Constants& constants);

}  // namespace host_sim::diagnose
