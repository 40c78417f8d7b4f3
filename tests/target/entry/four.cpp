#include "tests/target/entry/entry.hpp"

using target::Four;

bool push_four(Four* estimator, std::size_t tendon, std::int32_t tension_q29) {
  return estimator->push(tendon, lifemodel::Tension::from_raw(tension_q29));
}

bool settle_four(Four* estimator) {
  return estimator->settle();
}

void reading_four(Four* estimator, std::size_t tendon, lifemodel::Reading* out) {
  *out = estimator->reading(tendon);
}
