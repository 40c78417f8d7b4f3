#include "host_sim/life_law/life_design.hpp"

#include <cmath>
#include <cstddef>

namespace host_sim::life_law {
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
    group.lives.push_back(
        {.ln_cycles = std::log(datum.blocks.front().cycles), .failed = datum.failed});
    group.failures += datum.failed ? 1 : 0;
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
    sum += group.failures;
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

}  // namespace host_sim::life_law
