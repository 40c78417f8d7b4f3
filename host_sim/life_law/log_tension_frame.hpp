#pragma once

#include <span>

#include "host_sim/life_law/life_data.hpp"

namespace host_sim::life_law {

/// x = (ln T_eff - centre) / spread, so that it is of order one.
struct LogTensionFrame {
  double centre = 0;
  double spread = 1;

  [[nodiscard]] double x(double effective_tension_N) const;
};

/// Centred at the failures' last blocks, as wide as all loads.
LogTensionFrame frame_of(std::span<const LifeDatum> data);

}  // namespace host_sim::life_law
