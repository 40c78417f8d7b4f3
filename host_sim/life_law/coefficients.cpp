#include "host_sim/life_law/coefficients.hpp"

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace host_sim::life_law {
namespace {

void append_levels(std::span<const double> by_level, const Participation& participation,
                   std::vector<double>& out) {
  for (std::size_t level = 0; level < participation.levels(); ++level) {
    if (participation.column(level) != LifeDatum::kNoLevel) {
      out.push_back(level < by_level.size() ? by_level[level]
                                            : std::numeric_limits<double>::quiet_NaN());
    }
  }
}

std::vector<double> by_level(std::span<const double> columns, const Participation& participation,
                             double missing) {
  std::vector<double> levels(participation.levels(), missing);
  for (std::size_t level = 0; level < levels.size(); ++level) {
    if (participation.column(level) != LifeDatum::kNoLevel) {
      levels[level] = columns[participation.column(level)];
    }
  }
  return levels;
}

void append_scale(const LifeFit& fit, const LogTensionFrame& frame,
                  const Participation& participation, std::vector<double>& out) {
  if (fit.form.scale == LifeForm::Scale::free) {
    append_levels(fit.scale, participation, out);
    return;
  }
  const double shift = frame.centre - fit.centre_ln_N;
  const double curvature = fit.form.scale == LifeForm::Scale::curved ? fit.scale[2] : 0;
  out.push_back(fit.scale[0] - fit.scale[1] * shift + curvature * shift * shift);
  out.push_back((fit.scale[1] - 2 * curvature * shift) * frame.spread);
  if (fit.form.scale == LifeForm::Scale::curved) {
    out.push_back(curvature * frame.spread * frame.spread);
  }
}

void append_shape(const LifeFit& fit, const LogTensionFrame& frame,
                  const Participation& participation, std::vector<double>& out) {
  if (fit.form.shape == LifeForm::Shape::free) {
    append_levels(fit.shape, participation, out);
    return;
  }
  const double growth = fit.form.shape == LifeForm::Shape::growing ? fit.shape[1] : 0;
  out.push_back(fit.shape[0] + growth * (frame.centre - fit.centre_ln_N));
  if (fit.form.shape == LifeForm::Shape::growing) {
    out.push_back(growth * frame.spread);
  }
}

std::vector<double> in_powers_of_log_tension(std::span<const double> powers, double spread) {
  std::vector<double> out;
  double unit = 1;
  for (const double coefficient : powers) {
    out.push_back(coefficient / unit);
    unit *= spread;
  }
  return out;
}

}  // namespace

Eigen::VectorXd design_coefficients(const LifeFit& fit, const LogTensionFrame& frame,
                                    const Participation& participation) {
  std::vector<double> all;
  append_scale(fit, frame, participation, all);
  append_shape(fit, frame, participation, all);
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

void set_coefficients(LifeFit& fit, const Eigen::VectorXd& coefficients,
                      const LogTensionFrame& frame, const Participation& participation) {
  const bool free_scale = fit.form.scale == LifeForm::Scale::free;
  const bool free_shape = fit.form.shape == LifeForm::Shape::free;
  const std::size_t curved = fit.form.scale == LifeForm::Scale::curved ? 3 : 2;
  const std::span<const double> all(coefficients.data(),
                                    static_cast<std::size_t>(coefficients.size()));
  const std::size_t scales = free_scale ? participation.columns() : curved;
  fit.centre_ln_N = frame.centre;
  fit.scale = free_scale ? by_level(all.first(scales), participation,
                                    std::numeric_limits<double>::infinity())
                         : in_powers_of_log_tension(all.first(scales), frame.spread);
  fit.shape = free_shape ? by_level(all.subspan(scales), participation,
                                    std::numeric_limits<double>::quiet_NaN())
                         : in_powers_of_log_tension(all.subspan(scales), frame.spread);
}

}  // namespace host_sim::life_law
