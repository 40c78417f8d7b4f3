#include "host_sim/replay/until_date.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "host_sim/reference/equations.hpp"
#include "lifemodel/life/advice.hpp"
#include "lifemodel/life/conditional.hpp"
#include "lifemodel/pack/pack.hpp"

namespace host_sim {
namespace {

using lifemodel::Damage;
using lifemodel::RepresentativeCycle;
using lifemodel::numeric::Normal;
using lifemodel::pack::from_double;
using lifemodel::pack::to_double;

/// @pre value > 0
Normal normal_of(double value) {
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(value, &exponent), 32);
  return lifemodel::numeric::normal(
      static_cast<std::uint32_t>(std::min(mantissa, std::ldexp(1, 32) - 1)), exponent - 32);
}

/// The cycle that stands for all of a profile; half cycles count as such.
RepresentativeCycle cycle_of(const lifemodel::Reading& reading, lifemodel::Tension peak,
                             const lifemodel::CycleLaw& law) {
  const double cycles = std::max(static_cast<double>(reading.closed_cycles.raw()) +
                                     static_cast<double>(reading.open_half_cycles.raw()) / 2,
                                 0.5);
  return RepresentativeCycle::of(
      law, lifemodel::numeric::quotient(lifemodel::normalise(reading.total), normal_of(cycles)),
      peak);
}

/// By Gerber, all relative to the ultimate tension.
double effective_tension(double tension, double ratio) {
  const double mean = tension * (1 + ratio) / 2;
  return tension * (1 - ratio) / 2 / (1 - mean * mean);
}

}  // namespace

UntilDate until_date(const AskedUntil& asked, double used, const lifemodel::Reading& reading,
                     lifemodel::Tension peak, double duration_s,
                     const lifemodel::Parameters& parameters, double ultimate_tension_N,
                     double least_N) {
  UntilDate result;
  result.asked = asked;
  result.used = used;
  result.repeats = asked.hours() * 3600 / duration_s;
  result.peak_tension_N = to_double(peak) * ultimate_tension_N;
  if (reading.total.none()) {
    result.hours_to_risk = std::numeric_limits<double>::infinity();
    result.highest_tension_N = ultimate_tension_N;
    return result;
  }
  const lifemodel::WeibullShape shape = parameters.life.shape;
  const Damage before = lifemodel::pack::damage(used);
  const Damage needed = lifemodel::denormalise(
      lifemodel::numeric::product(lifemodel::normalise(reading.total), normal_of(result.repeats)));
  const Damage allowed = lifemodel::further_damage(
      shape, before, lifemodel::Hazard::of(from_double<lifemodel::Ratio>(asked.risk)));
  const RepresentativeCycle cycle = cycle_of(reading, peak, parameters.law);
  const lifemodel::Advice advice = lifemodel::advise(parameters.law, allowed, needed, cycle);

  result.hours_to_risk = asked.hours() * to_double(allowed) / to_double(needed);
  result.risk_as_it_is = to_double(lifemodel::break_risk(shape, before, needed));
  result.highest_tension_N = to_double(advice.tension) * ultimate_tension_N;
  result.pace = to_double(advice.pace);
  result.reachable = result.lasts_as_it_is() || result.highest_tension_N > least_N;
  const double ratio = std::ldexp(cycle.ratio.raw, -30);
  const double lower = std::min(to_double(advice.tension), to_double(peak));
  const double change =
      std::pow(effective_tension(lower, ratio) / effective_tension(to_double(peak), ratio),
               to_double(parameters.law.exponent));
  result.risk_with =
      reference::weibull_break_risk(used, to_double(needed) * change, to_double(shape));
  return result;
}

}  // namespace host_sim
