#include "tests/effects/trace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace host_sim::effects::testing {

recording::Covariates trace() {
  recording::Covariates made;
  double travel_m = 0;
  double position_m = 0.011;
  double last = 1;
  for (int k = 0; k < 40; ++k) {
    const double i = k;
    const double direction = (k / 10) % 2 == 0 ? 1 : -1;
    const double velocity_m_s = direction * (0.012 + 0.003 * (k % 7));
    travel_m = direction == last ? travel_m + 0.0001 * (1 + k % 3) : 0.00005;
    position_m += direction * 0.0001 * (1 + k % 3);
    last = direction;
    made.time_s.push_back(0.01 * i);
    made.cycle.push_back(700 + 0.5 * (k / 10));
    made.direction.push_back(direction);
    made.velocity_m_s.push_back(velocity_m_s);
    made.bend_angle_rad.push_back(2.1 + 0.001 * i);
    made.current_A.push_back(1.3 + 0.4 * std::sin(0.31 * i));
    made.current_tension_N.push_back(21.0 * made.current_A.back());
    made.output_tension_N.push_back(made.current_tension_N.back() *
                                    std::exp(-kMu * made.bend_angle_rad.back() * direction));
    made.travel_m.push_back(travel_m);
    made.position_m.push_back(position_m);
    made.motor_angle_rad.push_back(720 * position_m);
    made.log_tension_rate_1_s.push_back(9 * std::cos(0.31 * i));
    made.log_output_rate_1_s.push_back(7 * std::cos(0.23 * i));
    made.sheath_temperature_C.push_back(27 + 0.2 * i);
    made.winding_temperature_C.push_back(41 + 0.5 * i);
  }
  return made;
}

recording::Covariates trace_with_load_cell() {
  recording::Covariates made = trace();
  made.input_tension_N = made.current_tension_N;
  return made;
}

recording::Covariates with_output(recording::Covariates covariates,
                                  const std::function<double(std::size_t i)>& output_N) {
  std::vector<double> outputs_N;
  for (std::size_t i = 0; i < covariates.samples(); ++i) {
    outputs_N.push_back(output_N(i));
  }
  covariates.output_tension_N = std::move(outputs_N);
  return covariates;
}

std::vector<double> residuals(const recording::Covariates& covariates) {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < covariates.samples(); ++i) {
    residuals.push_back(std::log(covariates.output_tension_N[i] / covariates.tension_in_N()[i]) +
                        kMu * covariates.bend_angle_rad[i] * covariates.direction[i]);
  }
  return residuals;
}

const TensionEffect& effect(std::string_view id) {
  for (const auto& known : tension_effects()) {
    if (known->id() == id) {
      return *known;
    }
  }
  throw std::out_of_range(std::string(id));
}

std::vector<std::vector<double>> columns(std::string_view id,
                                         const recording::Covariates& covariates,
                                         const std::vector<double>& shape,
                                         const Baseline& baseline) {
  return effect(id).signature(covariates, baseline, shape).columns;
}

std::vector<double> derivative(const recording::Covariates& covariates,
                               const OutputTension& output_N, double step) {
  std::vector<double> slopes;
  for (std::size_t i = 0; i < covariates.samples(); ++i) {
    slopes.push_back((std::log(output_N(i, step)) - std::log(output_N(i, -step))) / (2 * step));
  }
  return slopes;
}

void expect_same(const std::vector<double>& found, const std::vector<double>& expected,
                 double tolerance) {
  ASSERT_EQ(found.size(), expected.size());
  double largest = 0;
  for (const double value : expected) {
    largest = std::max(largest, std::abs(value));
  }
  ASSERT_GT(largest, 0);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], tolerance * largest) << "sample " << i;
  }
}

}  // namespace host_sim::effects::testing
