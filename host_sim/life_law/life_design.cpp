#include "host_sim/life_law/life_design.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace host_sim::life_law {
namespace {

/// Loads closer together are one load that was rounded: x is zero for all.
constexpr double kNarrowest = 1e-6;
constexpr double kNoSpread = std::numeric_limits<double>::infinity();

double mean_of_failures(std::span<const LifeDatum> data) {
  double sum = 0;
  double failures = 0;
  for (const LifeDatum& datum : data) {
    if (datum.failed) {
      sum += std::log(datum.blocks.back().effective_tension_N);
      failures += 1;
    }
  }
  return failures > 0 ? sum / failures : 0;
}

}  // namespace

double LogTensionFrame::x(double effective_tension_N) const {
  return (std::log(effective_tension_N) - centre) / spread;
}

LogTensionFrame frame_of(std::span<const LifeDatum> data) {
  const double centre = mean_of_failures(data);
  double widest = 0;
  for (const LifeDatum& datum : data) {
    for (const LifeDatum::Block& block : datum.blocks) {
      widest = std::max(widest, std::abs(std::log(block.effective_tension_N) - centre));
    }
  }
  return {.centre = centre, .spread = widest > kNarrowest ? widest : kNoSpread};
}

namespace {

std::size_t levels_in(std::span<const LifeDatum> data) {
  std::size_t levels = 0;
  for (const LifeDatum& datum : data) {
    if (datum.level != LifeDatum::kNoLevel) {
      levels = std::max(levels, datum.level + 1);
    }
  }
  return levels;
}

}  // namespace

bool has_levels(LifeForm form) {
  return form.scale == LifeForm::Scale::free || form.shape == LifeForm::Shape::free;
}

Participation::Participation(std::span<const LifeDatum> data, LifeForm form)
    : by_level_(has_levels(form)) {
  const bool free = form.scale == LifeForm::Scale::free;
  std::vector<bool> from_above(levels_in(data), !free);
  std::vector<bool> from_below(from_above);
  for (const LifeDatum& datum : data) {
    if (datum.level != LifeDatum::kNoLevel) {
      from_above[datum.level] = from_above[datum.level] || datum.failed;
      from_below[datum.level] = from_below[datum.level] || datum.from_cycles != 0.0;
    }
  }
  std::vector<bool> part(from_above.size());
  for (std::size_t level = 0; level < part.size(); ++level) {
    part[level] = from_above[level] && from_below[level];
  }
  number(part);
}

Participation::Participation(const LifeFit& fit) : by_level_(has_levels(fit.form)) {
  std::vector<bool> part;
  if (fit.form.scale == LifeForm::Scale::free) {
    for (const double ln_scale : fit.scale) {
      part.push_back(std::isfinite(ln_scale));
    }
  } else if (by_level_) {
    part.assign(fit.shape.size(), true);
  }
  number(part);
}

void Participation::number(const std::vector<bool>& part) {
  for (const bool takes : part) {
    columns_of_levels_.push_back(takes ? columns_++ : LifeDatum::kNoLevel);
  }
}

bool Participation::takes_part(const LifeDatum& datum) const {
  if (!by_level_) {
    return true;
  }
  return datum.level < columns_of_levels_.size() &&
         columns_of_levels_[datum.level] != LifeDatum::kNoLevel;
}

namespace {

class RowMaker {
 public:
  RowMaker(LifeForm form, const LogTensionFrame& frame, const Participation& participation)
      : form_(form), frame_(frame), participation_(participation) {}

  [[nodiscard]] Eigen::VectorXd scale_row(const LifeDatum::Block& block, std::size_t level) const {
    const double x = frame_.x(block.effective_tension_N);
    switch (form_.scale) {
      case LifeForm::Scale::power_law:
        return Eigen::Vector2d(1, -x);
      case LifeForm::Scale::curved:
        return Eigen::Vector3d(1, -x, x * x);
      case LifeForm::Scale::free:
        break;
    }
    return indicator(level);
  }

  [[nodiscard]] Eigen::VectorXd shape_row(const LifeDatum& datum) const {
    switch (form_.shape) {
      case LifeForm::Shape::one:
        return Eigen::VectorXd::Ones(1);
      case LifeForm::Shape::growing:
        return Eigen::Vector2d(1, mean_x(datum));
      case LifeForm::Shape::free:
        break;
    }
    return indicator(datum.level);
  }

 private:
  [[nodiscard]] Eigen::VectorXd indicator(std::size_t level) const {
    const auto columns = static_cast<Eigen::Index>(participation_.columns());
    return Eigen::VectorXd::Unit(columns, static_cast<Eigen::Index>(participation_.column(level)));
  }

  /// Weighted by cycles.
  [[nodiscard]] double mean_x(const LifeDatum& datum) const {
    double sum = 0;
    double cycles = 0;
    for (const LifeDatum::Block& block : datum.blocks) {
      sum += block.cycles * frame_.x(block.effective_tension_N);
      cycles += block.cycles;
    }
    return sum / cycles;
  }

  LifeForm form_;
  const LogTensionFrame& frame_;
  const Participation& participation_;
};

LifeDesign::InBlocks in_blocks(const LifeDatum& datum, const RowMaker& rows,
                               Eigen::Index coefficients) {
  const auto blocks = static_cast<Eigen::Index>(datum.blocks.size());
  LifeDesign::InBlocks specimen{.scale_rows = Eigen::MatrixXd(coefficients, blocks),
                                .shape_row = rows.shape_row(datum),
                                .ln_cycles = Eigen::VectorXd(blocks),
                                .failed = datum.failed};
  for (Eigen::Index j = 0; j < blocks; ++j) {
    const LifeDatum::Block& block = datum.blocks[static_cast<std::size_t>(j)];
    specimen.scale_rows.col(j) = rows.scale_row(block, datum.level);
    specimen.ln_cycles[j] = std::log(block.cycles);
  }
  return specimen;
}

bool same_load(const LifeDatum& a, const LifeDatum& b) {
  return a.level == b.level &&
         a.blocks.front().effective_tension_N == b.blocks.front().effective_tension_N;
}

/// Adds specimens to a design, those in a row with the same load to one group.
class DesignBuilder {
 public:
  DesignBuilder(LifeDesign& design, const RowMaker& rows) : design_(design), rows_(rows) {}

  void add(const LifeDatum& datum) {
    if (datum.blocks.size() > 1) {
      design_.in_blocks.push_back(in_blocks(datum, rows_, design_.scale_coefficients));
      return;
    }
    if (previous_ == nullptr || !same_load(*previous_, datum)) {
      design_.constant.push_back({.scale_row = rows_.scale_row(datum.blocks.front(), datum.level),
                                  .shape_row = rows_.shape_row(datum),
                                  .lives = {}});
    }
    previous_ = &datum;
    LifeDesign::Constant& group = design_.constant.back();
    const statistics::Observation seen = datum.observation();
    group.lives.push_back({.ln_cycles = std::log(seen.value),
                           .failed = seen.failed,
                           .ln_from = std::log(seen.from.value_or(seen.value))});
    group.failures += seen.exact() ? 1 : 0;
  }

 private:
  LifeDesign& design_;
  const RowMaker& rows_;
  const LifeDatum* previous_ = nullptr;
};

Eigen::VectorXd ones(const Participation& participation) {
  return Eigen::VectorXd::Ones(static_cast<Eigen::Index>(participation.columns()));
}

Eigen::VectorXd scale_of_one(LifeForm form, const Participation& participation) {
  switch (form.scale) {
    case LifeForm::Scale::power_law:
      return Eigen::Vector2d::UnitX();
    case LifeForm::Scale::curved:
      return Eigen::Vector3d::UnitX();
    case LifeForm::Scale::free:
      break;
  }
  return ones(participation);
}

Eigen::VectorXd shape_of_one(LifeForm form, const Participation& participation) {
  switch (form.shape) {
    case LifeForm::Shape::one:
      return Eigen::VectorXd::Ones(1);
    case LifeForm::Shape::growing:
      return Eigen::Vector2d::UnitX();
    case LifeForm::Shape::free:
      break;
  }
  return ones(participation);
}

}  // namespace

double LifeDesign::failures() const {
  double sum = 0;
  for (const Constant& group : constant) {
    for (const Constant::Life& life : group.lives) {
      sum += life.failed ? 1 : 0;
    }
  }
  for (const InBlocks& specimen : in_blocks) {
    sum += specimen.failed ? 1 : 0;
  }
  return sum;
}

LifeDesign design_of(std::span<const LifeDatum> data, LifeForm form, const LogTensionFrame& frame,
                     const Participation& participation) {
  LifeDesign design;
  design.scale_of_one = scale_of_one(form, participation);
  design.shape_of_one = shape_of_one(form, participation);
  design.scale_coefficients = design.scale_of_one.size();
  design.shape_coefficients = design.shape_of_one.size();
  const RowMaker rows(form, frame, participation);
  DesignBuilder builder(design, rows);
  for (const LifeDatum& datum : data) {
    if (participation.takes_part(datum)) {
      builder.add(datum);
    }
  }
  return design;
}

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
