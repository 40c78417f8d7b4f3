#pragma once

namespace host_sim::reference {

/// A pair of turning points in the order in which the signal reached them.
struct Cycle {
  double from_N;
  double to_N;

  friend bool operator==(const Cycle&, const Cycle&) = default;
};

enum class Extent { kHalf, kFull };

}  // namespace host_sim::reference
