#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "host_sim/plan/search.hpp"

namespace host_sim::plan {

struct PlanRequest {
  Conditions conditions;
  Goal goal;  ///< an infinite ratio: nothing is searched
  /// One number for each level: what this design gives. Empty: the least of each allocation.
  std::vector<std::size_t> specimens;
  std::size_t specimens_max = 400;          ///< of a whole design
  double curvature_factor = 2;              ///< see Curvature
  std::optional<double> cycles_per_minute;  ///< of a rig, for the duration of a test
  SimulationOptions simulation;
  std::function<void(double)> progress;  ///< called with the share of designs done, 0 .. 1
};

/// One design with what it gives.
struct PlannedTest {
  std::string name;
  bool reached = false;  ///< whether it reaches the goal
  Design design;
  Outlook outlook;
  std::optional<double> curvature_power;  ///< none where it cannot show curvature
};

/// How far the use lies from the levels.
struct Extrapolation {
  double tension_factor = 1;  ///< the nearest level over the use, at least 1; 1 between levels
  double life_factor = 1;     ///< characteristic life at the use over that at the nearest level
  double ranges = 0;          ///< distance in ln T over that of the extreme levels
};

Extrapolation extrapolation_to(double use_tension_N, const Conditions& conditions);

struct PlanResult {
  double b10_cycles = 0;  ///< at the use, under the law
  Extrapolation extrapolation;
  std::vector<PlannedTest> tests;
  std::optional<std::size_t> fewest_specimens;  ///< index of the test; of those that reach the goal
  std::optional<std::size_t> fewest_cycles;
  std::optional<std::size_t> fewest_showing_curvature;  ///< specimens, of those that likely show it
};

/// Power from which on a design is said to show a curvature.
inline constexpr double kGoodPower = 0.8;

/// Days that a rig takes for so many cycles.
double days_of(double cycles, double cycles_per_minute);

/// Compares designs for one goal.
/// @pre at least two levels; specimens is empty or has one number for each level, two of them
///      above 0; specimens_max is at least twice the number of levels
/// @throws Interruption
PlanResult make_plan(const PlanRequest& request);

/// The result as JSON. What is infinite or does not exist is null.
std::string plan_json(const PlanRequest& request, const PlanResult& result);

/// The result for people.
void write_plan(std::ostream& out, const PlanRequest& request, const PlanResult& result);

}  // namespace host_sim::plan
