#include "host_sim/diagnose/lives/terms.hpp"

#include <map>

namespace host_sim::diagnose::lives {

std::vector<Term> terms_of(const std::string& effect, const LifeSample& sample) {
  using Make = std::vector<Term> (*)(const LifeSample&);
  static const std::map<std::string, Make> makes{{"ageing", ageing_terms},
                                                 {"bending_fatigue", bending_fatigue_terms},
                                                 {"endurance_limit", endurance_limit_terms},
                                                 {"load_sequence", load_sequence_terms},
                                                 {"lot_frailty", lot_frailty_terms},
                                                 {"mean_stress", mean_stress_terms},
                                                 {"second_mode", second_mode_terms}};
  return makes.at(effect)(sample);
}

}  // namespace host_sim::diagnose::lives
