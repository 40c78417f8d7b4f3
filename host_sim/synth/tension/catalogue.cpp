#include "host_sim/synth/tension/catalogue.hpp"

#include <vector>

#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {

std::span<const TensionKind> tension_kinds() {
  static const std::vector<TensionKind> kinds{
      friction_wear(), friction_temperature(), friction_velocity(), presliding(),
      friction_load(), friction_preload(),     friction_position(), slack(),
      compliance(),    current_offset(),       torque_gain(),       gear_asymmetry(),
      bend_angle(),    torque_ripple(),        filter_lag(),        undersampling(),
  };
  return kinds;
}

std::span<const TensionKind> outside_tension_kinds() {
  static const std::vector<TensionKind> kinds{
      sheath_creep(),           stick_slip(),
      load_cell_cross_talk(),   humidity_cycle(),
      tension_dependent_bend(), load_cell_thermal_lag(),
      rotor_inertia(),
  };
  return kinds;
}

}  // namespace host_sim::synth
