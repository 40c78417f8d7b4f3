#include "tests/blind/generator/dice.hpp"

#include <algorithm>
#include <cmath>

namespace blind {

double Dice::between(double low, double high) {
  return low + (high - low) * random_.uniform();
}

double Dice::log_between(double low, double high) {
  return low * std::pow(high / low, random_.uniform());
}

double Dice::sign() {
  return chance(0.5) ? 1 : -1;
}

bool Dice::chance(double probability) {
  return random_.uniform() < probability;
}

std::size_t Dice::below(std::size_t count) {
  const auto place = static_cast<std::size_t>(random_.uniform() * static_cast<double>(count));
  return std::min(place, count - 1);
}

}  // namespace blind
