#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "host_sim/life_law/life_fit.hpp"
#include "host_sim/life_law/log_tension_frame.hpp"
#include "host_sim/life_law/participation.hpp"

namespace host_sim::life_law {

/// Data as a form sees them. ln alpha of a block is its scale row times the first coefficients,
/// ln beta of a specimen is its shape row times the rest.
struct LifeDesign {
  /// Specimens under one constant load.
  struct Constant {
    struct Life {
      double ln_cycles;
      bool failed;
    };
    Eigen::VectorXd scale_row, shape_row;
    std::vector<Life> lives;
    double failures = 0;
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
  [[nodiscard]] double failures() const;
};

/// Rows of a form in x:
///   power law 1, -x; curved 1, -x, x^2; growing 1, x; one 1; free an indicator of the level.
LifeDesign design_of(std::span<const LifeDatum> data, LifeForm form, const LogTensionFrame& frame,
                     const Participation& participation);

}  // namespace host_sim::life_law
