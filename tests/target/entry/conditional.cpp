#include "lifemodel/life/conditional.hpp"

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
