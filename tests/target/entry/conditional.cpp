#include "lifemodel/life/conditional.hpp"

#include "lifemodel/life/advice.hpp"
#include "tests/target/entry/entry.hpp"

void given_survival(const lifemodel::WeibullShape* shape, const target::Wear* wear,
                    target::GivenSurvival* out) {
  using lifemodel::further_damage;
  const auto repeats = [&](lifemodel::Hazard hazard) {
    return lifemodel::repeats_within(further_damage(*shape, wear->used, hazard), wear->each);
  };
  *out = {repeats(lifemodel::kHazard10), repeats(lifemodel::kHazard50),
          repeats(lifemodel::kHazard90),
          lifemodel::break_risk(*shape, wear->used, wear->each.multiplied(480))};
}

void advised(const lifemodel::Parameters* parameters, const target::Wear* wear,
             target::Advised* out) {
  using lifemodel::RepresentativeCycle;
  const auto cycle =
      RepresentativeCycle::of(parameters->law, lifemodel::normalise(wear->each), out->peak);
  out->advice = lifemodel::advise(parameters->law, parameters->life.shape, wear->used,
                                  lifemodel::kHazard10, wear->each.multiplied(480), cycle);
}
