#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "host_sim/effects/tension_effect.hpp"
#include "host_sim/recording/covariates.hpp"
#include "host_sim/reference/constants.hpp"

namespace host_sim::effects {

/// One effect on what is counted of a tension. It changes no tension, so that r cannot show it and
/// it takes no part in a fit; what it costs in damage is computed from the recording itself.
class CountingEffect {
 public:
  CountingEffect() = default;
  CountingEffect(const CountingEffect&) = delete;
  CountingEffect& operator=(const CountingEffect&) = delete;
  virtual ~CountingEffect() = default;

  [[nodiscard]] virtual std::string_view id() const = 0;
  [[nodiscard]] virtual std::string_view term() const = 0;
  [[nodiscard]] virtual std::string_view equation() const = 0;  ///< of what is lost
  [[nodiscard]] virtual std::string_view life_consequence() const = 0;
  [[nodiscard]] virtual const Parameter& parameter() const = 0;  ///< what is swept
  [[nodiscard]] virtual std::span<const Separation> separations() const = 0;

  /// Empty where `covariates` hold what it needs, else what is missing, in words.
  [[nodiscard]] virtual std::string missing(const recording::Covariates& covariates) const = 0;

  /// The share of the damage of the input tension as recorded, counted without a threshold, that is
  /// lost with the parameter at `value`. Up to 1; below 0 where damage is gained; 0 where the
  /// recording does no damage.
  /// @pre missing() is empty, `value` within the bounds of the parameter
  [[nodiscard]] virtual double damage_lost(const recording::Covariates& covariates,
                                           const reference::Constants& constants,
                                           double value) const = 0;
};

/// All effects on counting, in order of their ids.
std::span<const std::unique_ptr<CountingEffect>> counting_effects();

}  // namespace host_sim::effects
