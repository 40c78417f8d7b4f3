#include "host_sim/diagnose/tension/estimates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "host_sim/diagnose/tension/model_fit.hpp"
#include "host_sim/statistics/distribution.hpp"

namespace host_sim::diagnose {
namespace {

using Eigen::Index;

constexpr double kHalfChiSquare95 = statistics::kNormal95 * statistics::kNormal95 / 2;

/// Relative steps away from the best shape.
constexpr std::array kSteps{1e-4, 3e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3, 0.7};

constexpr double kDegPerRad = 180 / std::numbers::pi;

struct Range {
  double low = 0, high = 0;
};

/// How far the evidence falls as one parameter of shape moves away, by kSteps.
std::vector<double> falls(const Evidence& evidence, std::span<const Component> model,
                          std::size_t part, std::size_t parameter, double sign) {
  std::vector<Component> others(model.begin(), model.end());
  const Component component = others[part];
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(part));
  Wanted moved{.effect = component.effect, .shapes = {component.shape}};
  for (const double step : kSteps) {
    moved.shapes.push_back(component.shape);
    moved.shapes.back()[parameter] *= 1 + sign * step;
  }
  std::vector<double> falls = evidences_at(evidence, others, moved);
  const double best = falls.front();
  for (double& value : falls) {
    value = best - value;
  }
  return falls;
}

/// The relative step at which the fall reaches `most`, by its square root between the steps tried.
double step_at(const std::vector<double>& falls, double most) {
  double step = 0;
  double root = 0;
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    const double next = std::sqrt(std::max(falls[i + 1], 0.0));
    if (next * next >= most) {
      const double share = (std::sqrt(most) - root) / (next - root);
      return std::lerp(step, kSteps[i], share);
    }
    step = kSteps[i];
    root = std::max(root, next);
  }
  return step;
}

Range shape_range(const Evidence& evidence, std::span<const Component> model, std::size_t part,
                  std::size_t parameter, double dispersion) {
  const double value = model[part].shape[parameter];
  if (value == 0 || !model[part].effect->shapes_between()) {
    return {value, value};
  }
  const double most = kHalfChiSquare95 * dispersion;
  const double up = value * (1 + step_at(falls(evidence, model, part, parameter, 1), most));
  const double down = value * (1 - step_at(falls(evidence, model, part, parameter, -1), most));
  return {std::min(up, down), std::max(up, down)};
}

/// With what the model itself may be off by, which is independent of the noise.
Estimate widened(Estimate estimate, const effects::Parameter& parameter) {
  const double off = statistics::kNormal95 * parameter.model_error * estimate.value;
  estimate.low = estimate.value - std::hypot(estimate.value - estimate.low, off);
  estimate.high = estimate.value + std::hypot(estimate.high - estimate.value, off);
  return estimate;
}

std::string pose_name(const effects::Parameter& parameter, double pose_rad) {
  return fmt::format("{}_at_{:.4g}_deg", parameter.name, pose_rad * kDegPerRad);
}

/// Of 95 %: as the noise of the model has it, or as sessions scatter, where that is more.
double half_width(const ModelFit& fit, Index place, double dispersion) {
  return std::max(statistics::kNormal95 * std::sqrt(dispersion * fit.covariance(place, place)),
                  statistics::student95(fit.degrees_of_freedom) *
                      std::sqrt(fit.covariance_by_sessions(place, place)));
}

/// Coefficients of a part's columns.
std::vector<Estimate> linear_estimates(const Fitted& by, const Component& component,
                                       std::size_t part, double dispersion) {
  const GramLayout::Block& block = by.grams.layout.effects[part].blocks.front();
  const bool per_pose = component.effect->per_pose();
  std::vector<Estimate> estimates;
  for (std::size_t i = 0; i < block.count; ++i) {
    const effects::Parameter& parameter = component.effect->parameters()[per_pose ? 0 : i];
    const auto place = static_cast<Index>(block.first + i);
    const double half = half_width(by.fit, place, dispersion);
    const double value = by.fit.coefficients(place);
    std::string name = per_pose ? pose_name(parameter, by.grams.baseline.poses_rad[i])
                                : std::string(parameter.name);
    const Estimate estimate{std::move(name), std::string(parameter.unit), value, value - half,
                            value + half};
    estimates.push_back(widened(estimate, parameter));
  }
  return estimates;
}

/// A size that is known by its share of the one that the signature was made with.
Estimate of_share(const Estimate& share, const effects::Parameter& size, double made_with) {
  const double one = share.low * made_with;
  const double other = share.high * made_with;
  return widened({std::string(size.name), std::string(size.unit), share.value * made_with,
                  std::min(one, other), std::max(one, other)},
                 size);
}

/// Sizes move with a shape, which is known no better than its range: their widths take that up.
void add_shape(const Evidence& evidence, std::span<const Component> model, std::size_t part,
               std::size_t parameter, const Range& range, std::span<Estimate> sizes) {
  if (range.low == range.high) {
    return;
  }
  std::vector<double> below(sizes.size());
  std::vector<double> above(sizes.size());
  for (const double end : {range.low, range.high}) {
    std::vector<Component> moved(model.begin(), model.end());
    moved[part].shape[parameter] = end;
    const Fitted by = fitted(evidence, moved);
    const std::size_t first = by.grams.layout.effects[part].blocks.front().first;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      const double off = by.fit.coefficients(static_cast<Index>(first + i)) - sizes[i].value;
      below[i] = std::max(below[i], -off);
      above[i] = std::max(above[i], off);
    }
  }
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    sizes[i].low = sizes[i].value - std::hypot(sizes[i].value - sizes[i].low, below[i]);
    sizes[i].high = sizes[i].value + std::hypot(sizes[i].high - sizes[i].value, above[i]);
  }
}

}  // namespace

std::vector<Estimate> estimates_of(const Evidence& evidence, std::span<const Component> model,
                                   std::size_t part, double dispersion) {
  const Component& component = model[part];
  std::vector<Estimate> estimates =
      linear_estimates(fitted(evidence, model), component, part, dispersion);
  const auto parameters = component.effect->parameters();
  const std::size_t linear = parameters.size() - component.shape.size();
  for (std::size_t i = 0; i < component.shape.size(); ++i) {
    const effects::Parameter& parameter = parameters[linear + i];
    const double value = component.shape[i];
    if (parameter.scaled_by_share) {
      estimates.front() = of_share(estimates.front(), parameter, value);
      continue;
    }
    const Range range = shape_range(evidence, model, part, i, dispersion);
    add_shape(evidence, model, part, i, range, std::span(estimates).first(linear));
    const Estimate estimate{std::string(parameter.name), std::string(parameter.unit), value,
                            range.low, range.high};
    estimates.push_back(range.low < range.high ? widened(estimate, parameter) : estimate);
  }
  return estimates;
}

namespace {

/// A model takes what physics allows alone.
double within_bounds(const Component& part, const Estimate& estimate) {
  const auto parameters = part.effect->parameters();
  const auto found = std::ranges::find(parameters, estimate.name, &effects::Parameter::name);
  return found == parameters.end() ? estimate.value
                                   : std::clamp(estimate.value, found->minimum, found->maximum);
}

}  // namespace

Extension extension_of(const Component& part, const std::vector<Estimate>& estimates,
                       const effects::Baseline& baseline) {
  Extension extension{.id = std::string(part.effect->id()), .values = {}};
  if (!part.effect->per_pose()) {
    for (const Estimate& estimate : estimates) {
      extension.values.push_back({estimate.name, {within_bounds(part, estimate)}});
    }
    return extension;
  }
  Extension::Value errors{.name = std::string(part.effect->parameters().front().name),
                          .values = {}};
  Extension::Value angles{.name = "bend_angles_deg", .values = {}};
  for (std::size_t i = 0; i < baseline.poses_rad.size(); ++i) {
    const effects::Parameter& error = part.effect->parameters().front();
    errors.values.push_back(std::clamp(estimates[i].value, error.minimum, error.maximum));
    angles.values.push_back(baseline.poses_rad[i] * kDegPerRad);
  }
  extension.values = {std::move(errors), std::move(angles)};
  return extension;
}

}  // namespace host_sim::diagnose
