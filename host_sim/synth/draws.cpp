#include "host_sim/synth/draws.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace host_sim::synth {

namespace {

std::mt19937_64 engine_for(std::uint64_t seed, std::uint64_t stream, std::uint64_t number) {
  const auto low = [](std::uint64_t value) { return static_cast<std::uint32_t>(value); };
  const auto high = [](std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32U); };
  std::seed_seq words{low(seed), high(seed), low(stream), high(stream), low(number), high(number)};
  return std::mt19937_64(words);
}

}  // namespace

Random::Random(std::uint64_t seed, std::uint64_t stream, std::uint64_t number)
    : engine_(engine_for(seed, stream, number)) {}

double Random::uniform() {
  constexpr double kStep = 0x1p-53;
  return (static_cast<double>(engine_() >> 11U) + 0.5) * kStep;
}

double normal(Random& random) {
  return boost::math::quantile(boost::math::normal(), random.uniform());
}

double student_t(Random& random, double dof) {
  const double t = boost::math::quantile(boost::math::students_t(dof), random.uniform());
  return t * std::sqrt((dof - 2) / dof);
}

double exponential(Random& random) {
  return -std::log(random.uniform());
}

}  // namespace host_sim::synth
