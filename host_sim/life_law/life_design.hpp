#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "host_sim/life_law/life_fit.hpp"

namespace host_sim::life_law {

/// x = (ln T_eff - centre) / spread, so that it is of order one.
struct LogTensionFrame {
  double centre = 0;
  double spread = 1;

  [[nodiscard]] double x(double effective_tension_N) const;
};

/// Centred at the failures' last blocks, as wide as all loads.
LogTensionFrame frame_of(std::span<const LifeDatum> data);

/// Which specimens take part in a form. Forms with free levels take only specimens that have a
/// level; where the scales are free, a level takes no part where nothing failed, or where all were
/// found broken when first looked at: its scale is at an end and its likelihood one.
class Participation {
 public:
  Participation(std::span<const LifeDatum> data, LifeForm form);
  /// That of a fit that was made before.
  explicit Participation(const LifeFit& fit);

  [[nodiscard]] bool takes_part(const LifeDatum& datum) const;

  /// Number of levels, those without a part included.
  [[nodiscard]] std::size_t levels() const { return columns_of_levels_.size(); }
  /// Number of levels that take part.
  [[nodiscard]] std::size_t columns() const { return columns_; }
  /// Place of a level among those that take part, or LifeDatum::kNoLevel.
  [[nodiscard]] std::size_t column(std::size_t level) const { return columns_of_levels_[level]; }

 private:
  void number(const std::vector<bool>& part);

  bool by_level_;
  std::vector<std::size_t> columns_of_levels_;
  std::size_t columns_ = 0;
};

/// Whether a form has a coefficient for each level.
bool has_levels(LifeForm form);

/// Data as a form sees them. ln alpha of a block is its scale row times the first coefficients,
/// ln beta of a specimen is its shape row times the rest.
struct LifeDesign {
  /// Specimens under one constant load.
  struct Constant {
    struct Life {
      double ln_cycles;
      bool failed;
      double ln_from;  ///< that of `ln_cycles` where the life is known, or minus infinity

      /// The life is known.
      [[nodiscard]] bool exact() const { return failed && ln_from == ln_cycles; }
    };
    Eigen::VectorXd scale_row, shape_row;
    std::vector<Life> lives;
    double failures = 0;  ///< whose life is known
  };

  /// One specimen loaded in blocks.
  struct InBlocks {
    Eigen::MatrixXd scale_rows;  ///< a column for each block
    Eigen::VectorXd shape_row;
    Eigen::VectorXd ln_cycles;
    bool failed = true;
  };

  Eigen::Index scale_coefficients = 0;
  Eigen::Index shape_coefficients = 0;
  /// Coefficients with which every specimen has one.
  Eigen::VectorXd scale_of_one, shape_of_one;
  std::vector<Constant> constant;
  std::vector<InBlocks> in_blocks;

  [[nodiscard]] Eigen::Index coefficients() const {
    return scale_coefficients + shape_coefficients;
  }
  /// Failures, those that were found broken too.
  [[nodiscard]] double failures() const;
};

/// Rows of a form in x:
///   power law 1, -x; curved 1, -x, x^2; growing 1, x; one 1; free an indicator of the level.
LifeDesign design_of(std::span<const LifeDatum> data, LifeForm form, const LogTensionFrame& frame,
                     const Participation& participation);

/// Coefficients of a design out of those of a fit, whose centre may be another.
Eigen::VectorXd design_coefficients(const LifeFit& fit, const LogTensionFrame& frame,
                                    const Participation& participation);

/// Sets centre and coefficients of a fit; a level without a part gets an infinite ln alpha, and its
/// ln beta is not a number.
void set_coefficients(LifeFit& fit, const Eigen::VectorXd& coefficients,
                      const LogTensionFrame& frame, const Participation& participation);

}  // namespace host_sim::life_law
