#pragma once

#include <concepts>
#include <limits>
#include <type_traits>

namespace lifemodel {

/// a + b; stops at the highest value.
template <std::unsigned_integral T>
constexpr T saturating_add(T a, std::type_identity_t<T> b) {
  T sum = 0;
  return __builtin_add_overflow(a, b, &sum) ? std::numeric_limits<T>::max() : sum;
}

}  // namespace lifemodel
