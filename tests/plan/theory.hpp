#pragma once

#include "host_sim/plan/design.hpp"

namespace host_sim::plan::testing {

/// The paper's law: section 3.5.
inline const LifeLaw kPaperLaw{.scale = 1.53e5, .exponent = 1.38, .shape = 5.94};

/// Standard error of ln B10 at a load for a large sample: from the expected information of the
/// Weibull power law in ln alpha = a - gamma x and ln beta, with specimens suspended at one life
/// (Meeker and Escobar 1998, section 17.7 and appendix B).
double standard_error_of_ln_b10(const Design& design, const LifeLaw& law, double use_tension_N);

/// Power of the likelihood-ratio test at 5 % for one more coefficient of ln alpha, for a large
/// sample without suspension: the noncentral chi-square with beta^2 times the squares that a
/// straight line, weighted with the specimens, leaves of `bend`, the change of ln alpha by level.
double power_to_see_bend(const Design& design, const LifeLaw& law, const std::vector<double>& bend);

/// The four levels of the paper's section 3.5.
Design paper_design(std::size_t specimens_of_level,
                    double suspend_at_cycles = std::numeric_limits<double>::infinity());

}  // namespace host_sim::plan::testing
