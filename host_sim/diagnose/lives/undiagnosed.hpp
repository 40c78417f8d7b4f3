#pragma once

#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/lives/life_sample.hpp"
#include "host_sim/diagnose/lives/nominal.hpp"

namespace host_sim::diagnose::lives {

/// Why the nominal law cannot be fitted to these lives, so that nothing can be asked of them; empty
/// where it can.
std::string hindrance(const LifeSample& sample, const NominalFit& nominal);

/// All that can be said then: nothing is named, each effect is invisible.
LifeDiagnosis undiagnosed(const Campaign& campaign, const std::string& why);

}  // namespace host_sim::diagnose::lives
