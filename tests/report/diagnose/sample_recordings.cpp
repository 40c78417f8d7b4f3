#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "host_sim/statistics/random.hpp"
#include "tests/report/diagnose/sample_pictures.hpp"

namespace host_sim::samples {
namespace {

constexpr double kFriction = 0.128;
constexpr std::size_t kSessions = 6;

double angle_of(std::size_t session) {
  return std::numbers::pi * (session % 2 == 0 ? 1.5 : 2.5);
}

/// ln of output over input tension, smooth through the reversals as a compliant sheath is.
double log_ratio(double friction, double angle_rad, double phase) {
  constexpr double kSharpness = 12;
  return -friction * angle_rad * std::tanh(kSharpness * std::cos(phase));
}

diagnose::TracePicture trace_of(std::size_t session, double wear) {
  constexpr std::size_t kSamples = 400;
  constexpr double kRate_Hz = 50;
  constexpr double kNoise = 0.01;
  diagnose::TracePicture trace;
  trace.session = fmt::format("s{}", session + 1);
  statistics::Random random(7, 1, session);
  const double worn = kFriction * (1 + wear * static_cast<double>(session) / (kSessions - 1));
  for (std::size_t i = 0; i < kSamples; ++i) {
    const double time_s = static_cast<double>(i) / kRate_Hz;
    const double phase = 2 * std::numbers::pi * 0.5 * time_s;
    const double input_N = 40 + 15 * std::sin(1.3 * phase);
    const double angle_rad = angle_of(session);
    trace.time_s.push_back(time_s);
    trace.input_N.push_back(input_N);
    trace.after_N.push_back(input_N * std::exp(log_ratio(worn, angle_rad, phase)));
    trace.before_N.push_back(input_N *
                             std::exp(log_ratio(kFriction * (1 + wear / 2), angle_rad, phase)));
    trace.measured_N.push_back(trace.after_N.back() * std::exp(kNoise * (random.uniform() - 0.5)));
  }
  return trace;
}

diagnose::RemainderPicture remainder_of(const std::string& covariate, const std::string& unit,
                                        int direction, double first, double last, double slope_N) {
  constexpr std::size_t kBins = 10;
  constexpr double kScatter_N = 0.5;
  diagnose::RemainderPicture remainder{covariate, unit, direction, {}, {}, {}, {}, {}};
  statistics::Random random(8, static_cast<std::uint64_t>(direction + 1), 0);
  for (std::size_t i = 0; i < kBins; ++i) {
    const double place = (static_cast<double>(i) + 0.5) / kBins;
    const double noise_N = kScatter_N * (random.uniform() - 0.5);
    remainder.centre.push_back(first + place * (last - first));
    remainder.before_N.push_back(direction * slope_N * (place - 0.5) + noise_N);
    remainder.before_sd_N.push_back(kScatter_N + std::abs(slope_N) / 10);
    remainder.after_N.push_back(noise_N);
    remainder.after_sd_N.push_back(kScatter_N);
  }
  return remainder;
}

}  // namespace

void add_traces(diagnose::TensionDiagnosis& tension, double wear) {
  for (std::size_t session = 0; session < kSessions; ++session) {
    tension.traces.push_back(trace_of(session, wear));
  }
}

void add_remainders(diagnose::TensionDiagnosis& tension, double wear) {
  constexpr double kOfWear_N = 40;
  for (const int direction : {1, -1}) {
    tension.remainders.push_back(
        remainder_of("cycle", "cycles", direction, 0, 4000, kOfWear_N * wear));
  }
  for (const int direction : {1, -1}) {
    tension.remainders.push_back(remainder_of("sheath temperature", "C", direction, 20, 45, 0));
  }
}

}  // namespace host_sim::samples
