#include "host_sim/synth/draws.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace host_sim::synth {

double normal(statistics::Random& random) {
  return boost::math::quantile(boost::math::normal(), random.uniform());
}

double student_t(statistics::Random& random, double dof) {
  const double t = boost::math::quantile(boost::math::students_t(dof), random.uniform());
  return t * std::sqrt((dof - 2) / dof);
}

double exponential(statistics::Random& random) {
  return -std::log(random.uniform());
}

}  // namespace host_sim::synth
