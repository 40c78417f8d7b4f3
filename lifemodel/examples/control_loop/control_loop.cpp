// The estimator in a control loop: here the loop is a for, and the motor a sine.
#include <cmath>
#include <cstdio>
#include <lifemodel/estimator.hpp>
#include <lifemodel/pack/pack.hpp>

int main() {
  const auto parameters = lifemodel::pack::parameters({.ultimate_tension_N = 177.4,
                                                       .hysteresis_N = 0.2,
                                                       .ipl_scale = 1.53e5,
                                                       .ipl_exponent = 1.38,
                                                       .weibull_shape = 5.94,
                                                       .tension_per_current_N_A = 20.59,
                                                       .sample_period_s = 1e-3});
  lifemodel::Estimator<1> estimator({*parameters});
  for (int tick = 0; tick < 60000; ++tick) {  // 60 s at 1 kHz, 20 pulls
    const double current_A = 1.2 - std::cos(tick * 2 * M_PI / 3000);
    if (estimator.push(0, lifemodel::pack::from_double<lifemodel::MotorCurrent>(current_A))) {
      estimator.settle();
    }
  }
  std::printf("life used: %.6f\n", lifemodel::pack::to_double(estimator.reading(0).total));
}
