#pragma once

#include <ostream>

#include "lifemodel/tendon.hpp"

namespace host_sim {

/// A CSV file of readings over time: the life used, as the firmware would tell it.
class TrajectoryFile {
 public:
  /// Writes the header. `ultimate_tension_N` turns tensions back into newtons.
  TrajectoryFile(std::ostream& out, double ultimate_tension_N);

  void write(double time_s, lifemodel::Tension tension, const lifemodel::Reading& reading);

 private:
  std::ostream& out_;
  double ultimate_tension_N_;
};

}  // namespace host_sim
