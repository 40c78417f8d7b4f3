#pragma once

#include <string>
#include <vector>

#include "host_sim/diagnose/lives/term.hpp"

namespace host_sim::diagnose::lives {

/// The forms of each effect, for one campaign, each in the file of its name.
std::vector<Term> ageing_terms(const LifeSample& sample);
std::vector<Term> bending_fatigue_terms(const LifeSample& sample);
std::vector<Term> endurance_limit_terms(const LifeSample& sample);
std::vector<Term> load_sequence_terms(const LifeSample& sample);
std::vector<Term> lot_frailty_terms(const LifeSample& sample);
std::vector<Term> mean_stress_terms(const LifeSample& sample);
std::vector<Term> second_mode_terms(const LifeSample& sample);

/// What no effect says, one for each covariate that the campaign has.
std::vector<Term> outside_terms(const LifeSample& sample);

/// The forms of one effect. @throws std::out_of_range
std::vector<Term> terms_of(const std::string& effect, const LifeSample& sample);

}  // namespace host_sim::diagnose::lives
