#pragma once

#include <array>
#include <cstddef>

#include "host_sim/statistics/distribution.hpp"

/// Samples of whole cycles in place of the lives that the paper measured but did not print.
namespace tendon_alt {

/// A row of the paper's Table 4, with the mean life of its Figure 10.
struct PrintedLevel {
  int bend_angle_deg;
  double scale_cycles;
  double shape;
  double mean_cycles;  ///< 0 where it is not printed
};

inline constexpr std::array<PrintedLevel, 6> kPrinted{{
    {270, 1060, 6.94, 993},
    {315, 854, 4.79, 783},
    {360, 675, 7.70, 634},
    {405, 551, 5.09, 506},
    {450, 407, 7.64, 383},
    {540, 236, 3.34, 0},
}};

/// Twenty lives for each row of kPrinted. The Weibull fit of each sample rounds to the printed
/// digits, and its mean to the printed mean. From 315 to 450 deg the common shape rounds to 5.94
/// and the likelihood ratio (18) lies in 5.7 .. 6.8; that of 540 deg against them rounds to 9.9.
std::array<host_sim::statistics::Sample, kPrinted.size()> lives_by_level();

/// Ten lives of the upper-arm application (section 4.1): mean 1.00e3, of which the 867 cycles that
/// the paper predicts are 13.6 % short; eight between the B10 and B90 lives of the paper's model at
/// 39.9 N and two above.
host_sim::statistics::Sample lives_of_upper_arm();

}  // namespace tendon_alt
