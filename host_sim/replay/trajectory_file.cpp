#include "host_sim/replay/trajectory_file.hpp"

#include <fmt/ostream.h>

#include "lifemodel/pack/pack.hpp"

namespace host_sim {

TrajectoryFile::TrajectoryFile(std::ostream& out, double ultimate_tension_N)
    : out_(out), ultimate_tension_N_(ultimate_tension_N) {
  out_ << "time_s,input_tension_N,damage_closed,damage_open,damage_total,closed_cycles,"
          "open_half_cycles\n";
}

void TrajectoryFile::write(double time_s, lifemodel::Tension tension,
                           const lifemodel::Reading& reading) {
  using lifemodel::pack::to_double;
  fmt::print(out_, "{},{:.6f},{},{},{},{},{}\n", time_s, to_double(tension) * ultimate_tension_N_,
             to_double(reading.closed), to_double(reading.open), to_double(reading.total),
             reading.closed_cycles.raw(), reading.open_half_cycles.raw());
}

}  // namespace host_sim
