// Any signal, settled at any time: damage within 1e-4 of the double-precision reference, never
// below it by more where the count was made larger on purpose, and never falling.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "host_sim/reference/reference.hpp"
#include "lifemodel/estimator.hpp"
#include "tests/lifemodel/support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lifemodel;
  if (size < 2) {
    return 0;
  }
  auto constants = lifemodel_test::paper_constants();
  constants.ipl_exponent = 1 + 11.0 * data[0] / 255;
  constants.ipl_scale = 1e4 * std::pow(constants.ultimate_tension_N, constants.ipl_exponent);
  constants.hysteresis_N = data[1] % 4 * 0.37;
  const Parameters parameters = *pack::parameters(constants);
  Estimator<1> estimator({parameters});
  host_sim::reference::Reference reference({constants.ultimate_tension_N, constants.hysteresis_N,
                                            constants.ipl_scale, constants.ipl_exponent,
                                            constants.weibull_shape});
  Damage before;
  for (std::size_t i = 2; i + 2 < size; i += 3) {
    std::int16_t word = 0;
    std::memcpy(&word, data + i, sizeof word);
    // Tensions that double and fixed point both hold exactly, so that ties are ties in both.
    const double relative = std::ldexp(word, -15);
    reference.push(relative * constants.ultimate_tension_N);
    estimator.push(0, pack::from_double<Tension>(relative));
    for (int call = 0; call < data[i + 2] % 4; ++call) {
      estimator.settle();
    }
    if (data[i + 2] % 16 != 0 && i + 5 < size) {
      continue;
    }
    const Reading ours = estimator.reading(0);
    const double exact = reference.reading().damage.total;
    const double total = pack::to_double(ours.total);
    // Damage is kept in steps of 2^-104, and a cycle adds at least one.
    const double steps = std::ldexp(static_cast<double>(size), -104);
    // Within an overrun the reading lags until the next turning point.
    const bool lags = ours.flags.has(Flag::overrun);
    const bool larger = lags || ours.flags.has(Flag::residue_overflow);
    if (ours.total < before || (!lags && total < exact * (1 - 1e-4) - steps) ||
        (!larger && total > exact * (1 + 1e-4) + steps)) {
      std::fprintf(stderr, "ours %.17g reference %.17g\n", total, exact);
      std::abort();
    }
    before = ours.total;
  }
  return 0;
}
