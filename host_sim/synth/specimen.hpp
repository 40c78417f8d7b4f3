#pragma once

#include <memory>
#include <span>
#include <vector>

#include "host_sim/model/model.hpp"
#include "host_sim/synth/life_departures.hpp"

namespace host_sim::synth {

/// Cycles at one frequency from one day on, while damage for each cycle grows by exp(rate t).
struct Calendar {
  double rate_1_day = 0;
  double first_day = 0;
  double frequency_Hz = 1;

  [[nodiscard]] double days_of(double cycles) const;

  /// How many cycles of day 0 do the same damage: the integral of exp(rate t) over the cycles.
  [[nodiscard]] double aged_cycles(double cycles) const;

  /// The inverse of aged_cycles().
  [[nodiscard]] double cycles_for(double aged_cycles) const;
};

using LifeParts = std::span<const std::unique_ptr<LifePart>>;

/// The nominal model of lives.
struct LifeModel {
  Model::Cable cable{};
  double friction_coefficient = 0;
  Model::Life life{};
};

/// A load for so many cycles at most.
struct LifeStep {
  LifeLoad load;
  double cycles = 0;
};

struct LifeResult {
  std::vector<double> cycles;  ///< of each step that was begun; whole numbers
  bool failed = false;
  double days = 0;  ///< in store and under test
};

/// Runs a specimen through its steps until it fails, or is suspended after the last one.
/// @param strength life over the characteristic life of its level, as the nominal model has it
/// @param parts of this specimen, whose begin() has been called
LifeResult run_specimen(const LifeModel& model, std::span<const LifeStep> steps, double strength,
                        double storage_days, LifeParts parts);

/// Fully reversed tension at a load: (12) - (14) and (11), with what the parts change.
double effective_tension_N(const LifeModel& model, const LifeLoad& load, LifeParts parts);

}  // namespace host_sim::synth
