#pragma once

#include <rapidcheck.h>

#include "scenario.hpp"

namespace rc {

template <>
struct Arbitrary<app::Roughness> {
  static Gen<app::Roughness> arbitrary() {
    using app::Roughness;
    const auto up_to = [](std::uint32_t highest) {
      return gen::inRange<std::uint32_t>(0, highest + 1);
    };
    return gen::build<Roughness>(
        gen::set(&Roughness::seed, gen::inRange<std::uint32_t>(1, 1u << 30)),
        gen::set(&Roughness::full_ppm, up_to(500'000)),
        gen::set(&Roughness::passive_ppm, up_to(10'000)), gen::set(&Roughness::bus_offs, up_to(3)),
        gen::set(&Roughness::missing_ppm, up_to(2'000)),
        gen::set(&Roughness::missed_ppm, up_to(1'000)),
        gen::set(&Roughness::unsaved_ppm, up_to(300'000)),
        gen::set(&Roughness::stop_ppm, up_to(3'000)),
        gen::set(&Roughness::commands_ppm, up_to(100'000)),
        gen::set(&Roughness::requests_ppm, up_to(100'000)), gen::set(&Roughness::babble, up_to(10)),
        gen::set(&Roughness::highest_N, gen::inRange<std::uint32_t>(6, 200)));
  }
};

}  // namespace rc
