#include "host_sim/diagnose/lives/term.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace host_sim::diagnose::lives {

double TermParameter::value(double u) const {
  const double at = centre + spread * u;
  return bounded ? minimum + (maximum - minimum) / (1 + std::exp(-at)) : at;
}

TermParameter parameter_of(const effects::LifeEffect& effect, std::string_view name,
                           double spread) {
  for (const effects::Parameter& parameter : effect.parameters()) {
    if (parameter.name == name) {
      const double share =
          (parameter.typical - parameter.minimum) / (parameter.maximum - parameter.minimum);
      return {.name = std::string(name),
              .unit = std::string(parameter.unit),
              .bounded = true,
              .minimum = parameter.minimum,
              .maximum = parameter.maximum,
              .centre = std::log(share / (1 - share)),
              .spread = spread};
    }
  }
  throw std::out_of_range("no parameter " + std::string(name));
}

TermParameter shift(std::string name, double sd) {
  return {.name = std::move(name), .unit = "1", .centre = 0, .spread = sd};
}

const effects::LifeEffect& life_effect(std::string_view id) {
  for (const auto& effect : effects::life_effects()) {
    if (effect->id() == id) {
      return *effect;
    }
  }
  throw std::out_of_range("no effect " + std::string(id));
}

}  // namespace host_sim::diagnose::lives
