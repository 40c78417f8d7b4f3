#pragma once

#include <concepts>

namespace hal {

/// Holds back the context that settles, while the context below it reads. The interrupt that
/// samples goes on. Does not nest.
template <class T>
concept Hold = requires(T& hold) {
  { hold.hold() } -> std::same_as<void>;
  { hold.release() } -> std::same_as<void>;
};

/// For boards where the same context settles and reads.
struct NoHold {
  void hold() {}
  void release() {}
};

}  // namespace hal
