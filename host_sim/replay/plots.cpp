#include "host_sim/replay/plots.hpp"

#include "host_sim/report/page/stretch.hpp"
#include "lifemodel/pack/pack.hpp"

namespace host_sim {

using lifemodel::Tension;

Plots::Plots(const Model& model, const lifemodel::Parameters& parameters, double class_N)
    : ultimate_tension_N_(model.cable.ultimate_tension_N),
      hysteresis_(parameters.hysteresis),
      range_mean_(class_N) {}

double Plots::newtons(Tension tension) const {
  return lifemodel::pack::to_double(tension) * ultimate_tension_N_;
}

void Plots::sample(double time_s, Tension tension) {
  envelope_.push(time_s, newtons(tension));
  if (first_) {
    first_ = false;
    candidate_s_ = time_s;
  }
  filter_.push(tension, hysteresis_,
               [&](Tension confirmed) { turning_points_.push(candidate_s_, newtons(confirmed)); });
  if (filter_.directed() && filter_.run().candidate() != candidate_) {
    candidate_ = filter_.run().candidate();
    candidate_s_ = time_s;
  }
}

void Plots::loop(double time_s, double input_N, double output_N) {
  constexpr std::size_t kMostSamples = 20'000;
  if (loop_.time_s.size() < kMostSamples) {
    loop_.time_s.push_back(time_s);
    loop_.input_N.push_back(input_N);
    loop_.output_N.push_back(output_N);
  }
}

void Plots::cycle(Tension from, Tension to, double count, lifemodel::CycleDamage damage) {
  range_mean_.push(newtons(from), newtons(to), count, lifemodel::pack::to_double(damage));
}

void Plots::finish(ReplayReport& report) {
  if (filter_.directed()) {
    turning_points_.push(candidate_s_, newtons(candidate_));
  }
  const Stretch cycles = cycles_in(loop_.input_N);
  report.loop = {part_of(loop_.time_s, cycles), part_of(loop_.input_N, cycles),
                 part_of(loop_.output_N, cycles)};
  report.tension = envelope_.finish();
  report.turning_points = turning_points_.finish();
  report.range_mean = range_mean_.finish();
  report.trajectory = trajectory_.finish();
}

}  // namespace host_sim
