#pragma once

#include <cstdint>

#include "lifemodel/extension/corrector.hpp"
#include "lifemodel/extension/life.hpp"

/// What an extended model costs, as functions of C linkage that are never inlined into what
/// measures them.
extern "C" {

std::int32_t correct_drive(lifemodel::extension::Corrector* corrector,
                           const lifemodel::extension::DriveSample* sample);
std::int32_t correct_sheath(lifemodel::extension::Corrector* corrector,
                            const lifemodel::extension::SheathSample* sample);
std::uint64_t damage_of_cycle(const lifemodel::extension::ExtendedLaw* law, std::int32_t from,
                              std::int32_t to);

}  // extern "C"
