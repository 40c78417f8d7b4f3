#include <new>

#include "tests/target/entry/entry.hpp"

using lifemodel::Tension;
using target::One;

bool push_one(One* estimator, std::int32_t tension_q29) {
  return estimator->push(0, Tension::from_raw(tension_q29));
}

bool settle_one(One* estimator) {
  return estimator->settle();
}

void reading_one(One* estimator, lifemodel::Reading* out) {
  new (out) lifemodel::Reading(estimator->reading(0));
}

std::size_t snapshot_one(const One* estimator, std::byte* out) {
  return estimator->snapshot({out, One::kSnapshotBytes}).size();
}

bool restore_one(One* estimator, const std::byte* bytes, std::size_t size) {
  return estimator->restore({bytes, size}) == lifemodel::SnapshotError::none;
}
