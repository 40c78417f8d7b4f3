#pragma once

namespace host_sim::statistics {

/// ln phi(z), the standard normal density.
double log_normal_density(double z);

/// ln Q(z), with Q the upper tail of the standard normal distribution; accurate for every z.
double log_normal_survival(double z);

/// phi(z) / Q(z), the hazard of the standard normal distribution; accurate for every z.
double normal_hazard(double z);

}  // namespace host_sim::statistics
