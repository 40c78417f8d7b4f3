#pragma once

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/lives/likelihood.hpp"

namespace host_sim::diagnose::lives {

/// Each life over alpha of the model, cox_snell^(1/beta), under the nominal law and the extended
/// one.
LifePicture picture_of(const LifeSample& sample, const LifeSettings& before,
                       const LifeSettings& after);

}  // namespace host_sim::diagnose::lives
