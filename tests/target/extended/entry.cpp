#include "tests/target/extended/entry.hpp"

using lifemodel::Flags;
using lifemodel::Tension;

std::int32_t correct_drive(lifemodel::extension::Corrector* corrector,
                           const lifemodel::extension::DriveSample* sample) {
  Flags flags;
  return corrector->input_tension(*sample, flags).raw();
}

std::int32_t correct_sheath(lifemodel::extension::Corrector* corrector,
                            const lifemodel::extension::SheathSample* sample) {
  Flags flags;
  return corrector->input_tension(*sample, flags).raw();
}

std::uint64_t damage_of_cycle(const lifemodel::extension::ExtendedLaw* law, std::int32_t from,
                              std::int32_t to) {
  return (*law)(Tension::from_raw(from), Tension::from_raw(to)).pack();
}
