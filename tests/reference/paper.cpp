#include "tests/reference/paper.hpp"

#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "host_sim/reference/equations.hpp"
#include "host_sim/reference/life.hpp"

namespace host_sim::reference::testing {
namespace {

constexpr double kFriction = 0.128;
constexpr double kUltimateNewton = 177.4;
constexpr double kIplScale = 1.53e5;
constexpr double kIplExponent = 1.38;
constexpr double kWeibullShape = 5.94;

double radians(double angle_deg) {
  return angle_deg * std::numbers::pi / 180.0;
}

double effective(const MeanAmplitude& input) {
  return gerber_effective_tension(input, kUltimateNewton);
}

double effective(const MeanAmplitude& output, double bend_deg, double friction_coefficient) {
  return effective(
      input_tension_range(output, capstan_efficiency(friction_coefficient, radians(bend_deg))));
}

double scale_cycles(double tension_N) {
  return ipl_life_cycles(tension_N, kIplScale, kIplExponent);
}

double mean_cycles(double tension_N) {
  return scale_cycles(tension_N) * weibull_mean_damage(kWeibullShape);
}

double life_cycles(double tension_N, double failed_fraction) {
  return scale_cycles(tension_N) * weibull_life_damage(failed_fraction, kWeibullShape);
}

double percent_above(double value, double base) {
  return 100.0 * (value / base - 1.0);
}

/// Scale and shape of each level in Table 4, 270 degrees first.
constexpr std::array<double, 5> kTable4Scale{1060, 854, 675, 551, 407};
constexpr std::array<double, 5> kTable4Shape{6.94, 4.79, 7.70, 5.09, 7.64};
constexpr std::array<double, 5> kTable4TensionNewton{35.1, 42.5, 50.7, 60.0, 70.8};

std::vector<double> table_4_means() {
  std::vector<double> means;
  for (std::size_t i = 0; i < kTable4Scale.size(); ++i) {
    means.push_back(kTable4Scale[i] * weibull_mean_damage(kTable4Shape[i]));
  }
  return means;
}

}  // namespace

std::vector<double> effective_tensions_N(double friction_coefficient) {
  std::vector<double> tensions_N;
  for (const double bend_deg : {270.0, 315.0, 360.0, 405.0, 450.0, 540.0}) {
    tensions_N.push_back(
        effective({.mean_N = 49.0, .amplitude_N = 0.0}, bend_deg, friction_coefficient));
  }
  tensions_N.push_back(
      effective({.mean_N = 38.5, .amplitude_N = 10.0}, 270.0, friction_coefficient));
  return tensions_N;
}

LeastSquares fit_table_4() {
  constexpr std::size_t kFirst = 1;  // 270 degrees is kept for validation
  const auto best_scale = [](double exponent) {
    double numerator = 0.0;
    double denominator = 0.0;
    for (std::size_t i = kFirst; i < kTable4Scale.size(); ++i) {
      const double unit_life = ipl_life_cycles(kTable4TensionNewton[i], 1.0, exponent);
      numerator += kTable4Scale[i] * unit_life;
      denominator += unit_life * unit_life;
    }
    return numerator / denominator;
  };
  const auto sum_of_squares = [&](double exponent) {
    const double scale = best_scale(exponent);
    double sum = 0.0;
    for (std::size_t i = kFirst; i < kTable4Scale.size(); ++i) {
      const double error =
          kTable4Scale[i] - ipl_life_cycles(kTable4TensionNewton[i], scale, exponent);
      sum += error * error;
    }
    return sum;
  };
  constexpr int kBits = 40;
  const auto [exponent, squares] =
      boost::math::tools::brent_find_minima(sum_of_squares, 0.5, 3.0, kBits);
  return {.ipl_scale = best_scale(exponent),
          .ipl_exponent = exponent,
          .rms_cycles = std::sqrt(squares / static_cast<double>(kTable4Scale.size() - kFirst))};
}

std::vector<PaperRow> paper_rows() {
  std::vector<double> levels_N = effective_tensions_N(kFriction);
  const double application_N = levels_N.back();
  levels_N.pop_back();

  const double exo_glove_N = effective({.mean_N = 25.0, .amplitude_N = 25.0});
  const MeanAmplitude sdm_hand = input_tension_range({.mean_N = 14.0, .amplitude_N = 14.0},
                                                     capstan_efficiency(kFriction, radians(250.0)));
  const double sdm_hand_N = effective(sdm_hand);

  const LeastSquares fit = fit_table_4();
  const std::array<TensionShare, 2> mix{{{40.0, 0.5}, {50.0, 0.5}}};

  return {
      {"T_eff at 270, 315, 360, 405, 450, 540 deg (N)",
       {35.1, 42.5, 50.7, 60.0, 70.8, 99.4},
       levels_N},
      {"T_eff of the upper-arm application (N)", {39.9}, {application_N}},
      {"mean life at 270, 315, 360, 405, 450 deg, of each level's own fit (cycles)",
       {993, 783, 634, 506, 383},
       table_4_means()},
      {"A by least squares", {1.53e5}, {fit.ipl_scale}},
      {"gamma by least squares", {1.38}, {fit.ipl_exponent}},
      {"RMSE of that fit (cycles)", {12.3}, {fit.rms_cycles}},
      {"mean life at 35.1 N (cycles)", {1044}, {mean_cycles(35.1)}},
      {"mean life at 39.9 N (cycles)", {867}, {mean_cycles(39.9)}},
      {"gamma between those two mean lives",
       {1.38},
       {std::log(1044.0 / 867.0) / std::log(39.9 / 35.1)}},
      {"prediction above the measured mean at 270 deg (%)",
       {5.1},
       {percent_above(mean_cycles(35.1), 993.0)}},
      {"measured mean above the prediction in the application (%)",
       {13.6},
       {percent_above(1000.0, mean_cycles(39.9))}},
      {"Exo-glove: T_eff (N)", {25.5}, {exo_glove_N}},
      {"Exo-glove: B10, mean, B90 (cycles)",
       {1.19e3, 1.74e3, 2.00e3},
       {life_cycles(exo_glove_N, 0.1), mean_cycles(exo_glove_N), life_cycles(exo_glove_N, 0.9)}},
      {"SDM hand: T_in mean, amplitude (N)", {24.5, 24.5}, {sdm_hand.mean_N, sdm_hand.amplitude_N}},
      {"SDM hand: T_eff (N)", {25.0}, {sdm_hand_N}},
      {"SDM hand: B10, mean, B90 (cycles)",
       {1.22e3, 1.79e3, 2.06e3},
       {life_cycles(sdm_hand_N, 0.1), mean_cycles(sdm_hand_N), life_cycles(sdm_hand_N, 0.9)}},
      {"40 and 50 N in equal parts: average of lives (N)",
       {44.34},
       {mix_by_life(mix, kIplExponent)}},
      {"40 and 50 N in equal parts: average of damage (N)",
       {44.34},
       {mix_by_damage(mix, kIplExponent)}},
  };
}

}  // namespace host_sim::reference::testing
