#pragma once

#include "host_sim/statistics/distribution.hpp"

namespace host_sim::statistics::published {

/// Endurance of 23 deep-groove ball bearings in 10^6 revolutions: Lieblein and Zelen, J. Res. Natl.
/// Bur. Stand. 57 (1956) 273. Reprints differ in the seventh life, 48.40 or 48.48; this is 48.40.
Sample ball_bearings();

/// Service of 70 diesel generator fans in 1000 hours, 12 failed: Nelson, Applied Life Data Analysis
/// (1982), p. 318.
Sample generator_fans();

/// 20 units in hours, 10 suspended at 500: NIST/SEMATECH e-Handbook of Statistical
/// Methods, 8.4.1.3.
Sample nist_units();

/// 38 vehicle shock absorbers in km, 11 failed, both modes: Meeker and Escobar, Statistical Methods
/// for Reliability Data (1998), p. 630.
Sample shock_absorbers();

/// 72 fatigue specimens of alloy T7987 in 1000 cycles, 5 suspended at 300: Meeker and Escobar
/// (1998), p. 131, as R package weibulltools 2.1.0 holds them. SAS reprints the second 152 as 153.
Sample alloy_t7987();

}  // namespace host_sim::statistics::published
