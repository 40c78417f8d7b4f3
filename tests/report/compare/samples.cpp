#include "tests/report/compare/samples.hpp"

#include <limits>

namespace host_sim::samples {
namespace {

using compare::Comparison;
using compare::Side;

/// A minute up and down that uses this much life.
Side side_of(const std::string& profile, const std::string& model, double damage) {
  Side side{profile, model, {}, "N"};
  ReplayReport& report = side.report;
  report.duration_s = 60;
  report.damage = {damage, 0, damage};
  report.equivalent_effective_tension_N = 40;
  report.ultimate_tension_N = 176;
  report.peak_ratio = 0.5;
  const double repeats = damage > 0 ? 1 / damage : std::numeric_limits<double>::infinity();
  report.repeats_to = {repeats / 2, repeats, repeats, 2 * repeats};
  report.model_digest = "5ed12218";
  report.weibull_shape = 6;
  report.tension = {{0, 30, 60}, {10, 60, 20}, {10, 60, 20}, 1, {}};
  report.trajectory = {{0, 30, 60}, {0, damage / 2, damage}};
  return side;
}

}  // namespace

std::vector<ComparisonSample> all_comparisons() {
  Comparison models;
  models.of_models = true;
  models.sides = {side_of("arm.csv", "stiff.toml", 0.02), side_of("arm.csv", "b<b>.toml", 0.03)};
  models.differences = {{"sheath.friction_coefficient", 0.128, 0.15, 0.8},
                        {"drive.gear_ratio", std::nullopt, 9, std::nullopt}};
  models.classes = {{{48, 52}, {34, 36}, {2, 3}, {0.02, 0.029}},
                    {{8, 12}, {4, 6}, {1, 1}, {0, 1e-3}}};
  models.apart_s = 30;

  Comparison profiles;
  profiles.sides = {side_of("old.csv", "m.toml", 0.02), side_of("new.csv", "m.toml", 0.01)};
  profiles.first = {30, 3, 4, 60, 50};
  profiles.classes = {{{48, 52}, {34, 36}, {2, 1}, {0.02, 0.01}}};
  profiles.sides[1].report.tension = {{0, 5000, 10000}, {9, 10, 11}, {58, 60, 62}, 64, {}};
  profiles.sides[1].report.duration_s = 10000;
  profiles.sides[1].report.warnings = {"the wire hangs loose"};

  Comparison idle;
  idle.sides = {side_of("one.csv", "m.toml", 0), side_of("two.csv", "m.toml", 0)};
  return {{"typical", models, 4}, {"profiles", profiles, 4}, {"idle", idle, 2}};
}

}  // namespace host_sim::samples
