#include "tests/verbs/hand_made_result.hpp"

#include <cmath>
#include <limits>

namespace host_sim_test {
namespace {

using host_sim::Campaign;
using namespace host_sim::calibrate;
using host_sim::statistics::Family;
using host_sim::statistics::FitProblem;
using host_sim::statistics::GoodnessOfFit;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

LevelResult level(double bend_angle_deg, double tension_N, double scale, double shape) {
  LevelResult level;
  level.load = {bend_angle_deg, 60, 30, tension_N};
  level.sample = {{800, true}, {900, true}, {1000, false}};
  level.fits = {{{{Family::normal, 870, 70}, -20.5, FitProblem::none},
                 {{Family::lognormal, 6.75, 0.1}, -19.5, FitProblem::none},
                 {{Family::weibull, scale, shape}, -20, FitProblem::none}}};
  level.goodness = {GoodnessOfFit{0.11, 0.51, 0.21, 0.61}, GoodnessOfFit{0.12, 0.52, 0.22, 0.62},
                    GoodnessOfFit{0.13, 0.53, 0.23, 0.63}};
  level.shape_unbiased = 5.5;
  level.mean_life = 790;
  level.band = {{0.1, 0.9}, {500, 900}, {700, kInfinite}};
  level.positions = {{800, 0.2}, {900, 0.5}};
  return level;
}

CommonShape common_shape() {
  CommonShape shape;
  shape.value = 5.94;
  shape.ci95 = {5, 7};
  shape.unbiased = 5.7;
  shape.homogeneity = {0.5, 1, 0.479, 0.5};
  shape.with_all_levels = Test{9.9, 2, 0.007, 0.01};
  shape.odd_levels = {{0, {0.3, 1, 0.58, 0.6}, 1}, {2, {9.5, 1, 0.002, 0.003}, 0.009}};
  return shape;
}

StressLife stress_life() {
  StressLife life;
  life.law = {2e5, 1.5, 6};
  life.log_likelihood = -123.456;
  life.scale_ci95 = {1e5, kInfinite};
  life.exponent_ci95 = {1.25, 1.75};
  life.shape_ci95 = {5, 7};
  life.pivot_tension_N = 50;  // alpha 2e5 / 50^1.5 = 565.7
  life.life_at_pivot_ci95 = {500, 640};
  life.shape_unbiased = 5.75;
  life.least_squares = LifeLaw{1.53e5, 1.38, 5.94};
  life.least_squares_rmse = 12.25;
  life.against_curvature = Test{1.5, 1, 0.221, kNone};
  life.band_tension_N = {40, 50};
  life.band_mean = {{600, 800}, {500, 700}};
  return life;
}

}  // namespace

CalibrateResult hand_made_result() {
  CalibrateResult result;
  result.campaign = "by hand";
  result.specimens = 9;
  result.failed = 6;
  result.suspended = 3;
  result.in_blocks = 1;
  result.levels = {level(315, 42.5, 854, 4.79), level(360, 50.75, 675, 7.7),
                   level(540, 99.5, 236, 3.34), level(270, 35.25, 1060, 6.94)};
  result.levels[2].left_out = "its shape is another";
  result.levels[3].role = Campaign::Role::validation;
  result.common_shape = common_shape();
  result.stress_life = stress_life();
  result.use_levels = {
      {"arm, upper", 39.9, 885, 647, 870, 1100, {816, 961}, {572, kInfinite}, {495, 1224}}};
  ValidationResult validation;
  validation.level = 3;
  validation.predicted_mean = 1068;
  validation.measured_mean = 993;
  validation.ratio_ci95 = {0.8, 1.1};
  validation.p = 0.25;
  validation.below_b10 = 1;
  validation.inside_b10_b90 = 2;
  validation.words = "not refuted";
  result.validation = {validation};
  result.mixes = {{"mix", {{40, 0.5}, {50, 0.5}}, 45.11, 44.34}};
  result.seed = 7;
  result.bootstraps = 500;
  result.warnings = {"first", "second"};
  return result;
}

CalibrateResult result_without_fits() {
  CalibrateResult result;
  result.campaign = "bad \xff name";
  result.specimens = 2;
  result.failed = 1;
  result.suspended = 1;
  LevelResult one;
  one.load.effective_tension_N = 40;
  one.sample = {{10, true}, {20, false}};
  for (auto& fit : one.fits) {
    fit.problem = FitProblem::too_few_failures;
  }
  result.levels = {one};
  result.warnings = {"there is no life law"};
  return result;
}

Campaign campaign_with_model() {
  Campaign campaign;
  campaign.name = "by hand";
  campaign.folder = "folder";
  campaign.nominal.cable = {0.457, 177.4};
  campaign.nominal.sheath = {0.128, 270};
  campaign.nominal.drive = {0.0325, 9, 0.88, 12.5, -0.1};
  campaign.nominal.counting = {1000, 0.2};
  return campaign;
}

}  // namespace host_sim_test
