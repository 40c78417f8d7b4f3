#include "host_sim/life_law/life_likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace host_sim::life_law {
namespace {

/// Log likelihood of specimens with one shape, and its derivatives with respect to u, the logarithm
/// of the damage, and phi, the logarithm of the shape. With z = u exp(phi) a specimen adds
///   failed     phi + z - exp(z) - u    (the density with respect to damage)
///   suspended  -exp(z)
///   between    ln(exp(-exp(y)) - exp(-exp(z))), y that of the damage that it survived
struct WeibullSlopes {
  double value = 0;
  double u = 0, phi = 0;
  double u_u = 0, u_phi = 0, phi_phi = 0;

  void add(double ln_damage, double ln_shape, double shape, bool failed) {
    const double z = shape * ln_damage;
    const double e = std::exp(z);
    value -= e;
    u -= shape * e;
    phi -= z * e;
    u_u -= shape * shape * e;
    u_phi -= shape * e * (1 + z);
    phi_phi -= z * e * (1 + z);
    if (failed) {
      value += ln_shape + z - ln_damage;
      u += shape - 1;
      phi += 1 + z;
      u_phi += shape;
      phi_phi += z;
    }
  }

  /// @param ln_from minus infinity where it survived nothing that is known
  void add_between(double ln_from, double ln_damage, double shape) {
    constexpr double kNothingLeft = 700;
    const double y = std::isinf(ln_from) ? 0 : shape * ln_from;
    const double z = shape * ln_damage;
    const double hazard_y = std::isinf(ln_from) ? 0 : std::exp(y);
    const double hazard_z = std::exp(z);
    const double more = hazard_y > 0 ? hazard_y * std::expm1(z - y) : hazard_z;
    const double p = -std::expm1(-more);  // to break, of those that survived so far
    // Densities over that probability, by y and z, and how they bend.
    const double at_y = hazard_y / p;
    const double at_z = more < kNothingLeft ? hazard_z * std::exp(-more) / p : 0;
    const double bend_y = at_y * (1 - hazard_y);
    const double bend_z = at_z > 0 ? at_z * (1 - hazard_z) : 0;

    const double by_u = shape * (at_z - at_y);
    const double by_phi = at_z * z - at_y * y;
    value += std::log(p) - hazard_y;
    u += by_u;
    phi += by_phi;
    u_u += shape * shape * (bend_z - bend_y) - by_u * by_u;
    u_phi += shape * (bend_z * z - bend_y * y + at_z - at_y) - by_u * by_phi;
    phi_phi += bend_z * z * z - bend_y * y * y + by_phi - by_phi * by_phi;
  }
};

using Row = Eigen::Ref<const Eigen::VectorXd>;

class Accumulator {
 public:
  Accumulator(const LifeDesign& design, const Eigen::VectorXd& coefficients, Expansion& expansion)
      : scale_(design.scale_coefficients),
        shape_(design.shape_coefficients),
        coefficients_(coefficients),
        expansion_(expansion) {}

  void add(const LifeDesign::Constant& group) {
    const double ln_alpha = group.scale_row.dot(coefficients_.head(scale_));
    const double ln_shape = group.shape_row.dot(coefficients_.tail(shape_));
    const double shape = std::exp(ln_shape);
    WeibullSlopes slopes;
    for (const LifeDesign::Constant::Life& life : group.lives) {
      if (life.failed && !life.exact()) {
        slopes.add_between(life.ln_from - ln_alpha, life.ln_cycles - ln_alpha, shape);
      } else {
        slopes.add(life.ln_cycles - ln_alpha, ln_shape, shape, life.failed);
      }
    }
    add(slopes, group.scale_row, group.shape_row);
    add_failures(group.failures, ln_alpha, group.scale_row);
  }

  void add(const LifeDesign::InBlocks& specimen) {
    const Eigen::VectorXd ln_alpha = specimen.scale_rows.transpose() * coefficients_.head(scale_);
    const Eigen::VectorXd ln_parts = specimen.ln_cycles - ln_alpha;
    const double largest = ln_parts.maxCoeff();
    const double ln_damage = largest + std::log((ln_parts.array() - largest).exp().sum());
    const Eigen::VectorXd shares = (ln_parts.array() - ln_damage).exp();
    const Eigen::VectorXd mean_row = specimen.scale_rows * shares;
    const double ln_shape = specimen.shape_row.dot(coefficients_.tail(shape_));

    WeibullSlopes slopes;
    slopes.add(ln_damage, ln_shape, std::exp(ln_shape), specimen.failed);
    add(slopes, mean_row, specimen.shape_row);
    expansion_.hessian.topLeftCorner(scale_, scale_) +=
        slopes.u * (specimen.scale_rows * shares.asDiagonal() * specimen.scale_rows.transpose() -
                    mean_row * mean_row.transpose());
    if (specimen.failed) {
      const Eigen::Index last = ln_alpha.size() - 1;
      add_failures(1, ln_alpha[last], specimen.scale_rows.col(last));
    }
  }

 private:
  /// The part that depends on damage; the gradient of its logarithm is minus `scale_row`.
  void add(const WeibullSlopes& slopes, const Row& scale_row, const Row& shape_row) {
    expansion_.value += slopes.value;
    expansion_.gradient.head(scale_) -= slopes.u * scale_row;
    expansion_.gradient.tail(shape_) += slopes.phi * shape_row;
    auto& hessian = expansion_.hessian;
    hessian.topLeftCorner(scale_, scale_) += slopes.u_u * scale_row * scale_row.transpose();
    hessian.topRightCorner(scale_, shape_) -= slopes.u_phi * scale_row * shape_row.transpose();
    hessian.bottomLeftCorner(shape_, scale_) -= slopes.u_phi * shape_row * scale_row.transpose();
    hessian.bottomRightCorner(shape_, shape_) += slopes.phi_phi * shape_row * shape_row.transpose();
  }

  /// The density per cycle is that per damage over alpha of the last block.
  void add_failures(double failures, double ln_alpha, const Row& scale_row) {
    expansion_.value -= failures * ln_alpha;
    expansion_.gradient.head(scale_) -= failures * scale_row;
  }

  Eigen::Index scale_;
  Eigen::Index shape_;
  const Eigen::VectorXd& coefficients_;
  Expansion& expansion_;
};

}  // namespace

double largest_ln_shape(const LifeDesign& design, const Eigen::VectorXd& coefficients) {
  const auto ln_shapes = coefficients.tail(design.shape_coefficients);
  double largest = -std::numeric_limits<double>::infinity();
  for (const LifeDesign::Constant& group : design.constant) {
    largest = std::max(largest, group.shape_row.dot(ln_shapes));
  }
  for (const LifeDesign::InBlocks& specimen : design.in_blocks) {
    largest = std::max(largest, specimen.shape_row.dot(ln_shapes));
  }
  return largest;
}

void expand_log_likelihood(const LifeDesign& design, const Eigen::VectorXd& coefficients,
                           Expansion& expansion) {
  expansion.reset(design.coefficients());
  if (largest_ln_shape(design, coefficients) > kLargestLnShape) {
    expansion.value = -std::numeric_limits<double>::infinity();
    return;
  }
  Accumulator accumulator(design, coefficients, expansion);
  for (const LifeDesign::Constant& group : design.constant) {
    accumulator.add(group);
  }
  for (const LifeDesign::InBlocks& specimen : design.in_blocks) {
    accumulator.add(specimen);
  }
}

}  // namespace host_sim::life_law
