#pragma once

#include <cmath>

namespace host_sim::life_law {

/// Log likelihood of specimens with one shape, and its derivatives with respect to u, the logarithm
/// of the damage, and phi, the logarithm of the shape. With z = u exp(phi) a specimen adds
///   failed     phi + z - exp(z) - u    (the density with respect to damage)
///   suspended  -exp(z)
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
};

}  // namespace host_sim::life_law
