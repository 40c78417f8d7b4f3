#include "host_sim/diagnose/force/alone.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>
#include <utility>

namespace host_sim::diagnose {
namespace {

struct UnitFactor {
  double times;
  std::string_view words;
};

constexpr UnitFactor kOfForces[] = {{1000, "mA and A, or N and kN"},
                                    {9.81, "N and kilograms-force"},
                                    {4.448, "N and pounds-force"}};

constexpr UnitFactor kOfMotions[] = {{1000, "mm and m"},
                                     {180 / std::numbers::pi, "degrees and radians"},
                                     {60, "turns a minute and turns a second"},
                                     {30 / std::numbers::pi, "turns a minute and rad/s"},
                                     {2 * std::numbers::pi, "radians and turns"},
                                     {6, "turns a minute and degrees a second"},
                                     {25.4, "mm and inches"}};

/// Of the factors the nearest one.
std::string prose_of(double factor, std::span<const UnitFactor> units) {
  constexpr double kAbout = 1.15;
  double least = std::log(kAbout);
  std::string_view nearest;
  for (const UnitFactor& unit : units) {
    for (const double ratio : {factor / unit.times, factor * unit.times}) {
      if (const double off = std::abs(std::log(std::abs(ratio))); off < least) {
        least = off;
        nearest = unit.words;
      }
    }
  }
  return nearest.empty() ? "" : fmt::format(", as between {}", nearest);
}

}  // namespace

std::optional<Alone> alone(const effects::ForceRecord& record, std::ptrdiff_t input_later,
                           std::ptrdiff_t velocity_later) {
  constexpr double kSettled = 0.1;  // of the largest speed
  constexpr double kFewest = 10;
  double most_m_s = 0;
  for (const double velocity_m_s : record.velocity_m_s) {
    most_m_s = std::max(most_m_s, std::abs(velocity_m_s));
  }
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  Eigen::Vector3d product = Eigen::Vector3d::Zero();
  double input_N2 = 0;
  double size_N = 0;
  double angle_rad = 0;
  double count = 0;
  const auto samples = static_cast<std::ptrdiff_t>(record.samples());
  const auto last = samples - std::max({input_later, velocity_later, std::ptrdiff_t{0}});
  constexpr std::ptrdiff_t kMostSamples = 2000;
  const auto first = -std::min({input_later, velocity_later, std::ptrdiff_t{0}});
  const std::ptrdiff_t step = std::max<std::ptrdiff_t>(samples / kMostSamples, 1);
  for (std::ptrdiff_t i = first; i < last; i += step) {
    const auto at = static_cast<std::size_t>(i);
    const double velocity_m_s = record.velocity_m_s[static_cast<std::size_t>(i + velocity_later)];
    if (!record.used[at] || std::abs(velocity_m_s) < kSettled * most_m_s) {
      continue;
    }
    const double way = velocity_m_s < 0 ? -1 : 1;
    const double input_N = record.input_N[static_cast<std::size_t>(i + input_later)];
    const Eigen::Vector3d row(record.output_N[at], way * std::abs(record.output_N[at]), way);
    square += row * row.transpose();
    product += row * input_N;
    input_N2 += input_N * input_N;
    size_N += std::abs(record.output_N[at]);
    angle_rad += record.bend_angle_rad[at];
    ++count;
  }
  if (count < kFewest || square(0, 0) <= 0 || size_N <= 0) {
    return std::nullopt;
  }
  const double without_N2 = input_N2 - product(0) * product(0) / square(0, 0);
  Eigen::Matrix3d damped = square;
  damped.diagonal() *= 1 + 1e-9;  // of a force that stays, two columns are one
  const Eigen::Vector3d by = damped.ldlt().solve(product);
  Alone seen;
  seen.friction = (by(1) * size_N + by(2) * count) / size_N;
  // Where friction takes off exp(x) the gain is by g cosh x, and this is g sinh x.
  const double gain2 = by(0) * by(0) - seen.friction * seen.friction;
  seen.gain = gain2 > 0 ? std::copysign(std::sqrt(gain2), by(0)) : by(0);
  seen.most_gain = by(0);
  seen.square_N2 = std::max(input_N2 - product.dot(by), 0.0) / count;
  const double friction_alone_N2 =
      input_N2 -
      product.tail<2>().dot(damped.bottomRightCorner<2, 2>().ldlt().solve(product.tail<2>()));
  seen.by_output = friction_alone_N2 > 0 ? 1 - seen.square_N2 * count / friction_alone_N2 : 0;
  seen.shown = without_N2 > 0 ? 1 - seen.square_N2 * count / without_N2 : 0;
  seen.mean_angle_rad = angle_rad / count;
  return seen;
}

std::string column(hal::files::ProfileColumnId id) {
  return std::string(hal::files::profile_columns()[id].name);
}

std::string input_column(const effects::ForceRecord& record) {
  return column(record.input_N_per_A > 0 ? hal::files::kMotorCurrentColumn
                                         : hal::files::kInputTensionColumn);
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

std::string unit_prose(double factor) {
  return prose_of(factor, kOfForces);
}

std::string motion_unit_prose(double factor) {
  return prose_of(factor, kOfMotions);
}

}  // namespace host_sim::diagnose
