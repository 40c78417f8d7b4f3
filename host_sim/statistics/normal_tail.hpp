#pragma once

namespace host_sim::statistics {

/// Quantile of 97.5 % of the standard normal distribution: half the width of an interval of 95 %.
inline constexpr double kNormal95 = 1.959963984540054;

/// ln phi(z), the standard normal density.
double log_normal_density(double z);

/// ln Q(z), with Q the upper tail of the standard normal distribution; accurate for every z.
double log_normal_survival(double z);

/// phi(z) / Q(z), the hazard of the standard normal distribution; accurate for every z.
double normal_hazard(double z);

}  // namespace host_sim::statistics
