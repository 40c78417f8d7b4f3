#include "host_sim/effects/tension/force_model.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "host_sim/effects/tension/contact.hpp"
#include "host_sim/effects/tension/forward.hpp"

namespace host_sim::effects {
namespace {

/// A sensor that follows by a first-order lag, exact where the force goes on a line or in one step.
class Lag {
 public:
  explicit Lag(double lag_s) : lag_s_(lag_s) {}

  /// @param since_s the time since the force stepped, after the sample before; none: on a line
  double read(double force_N, double time_s, std::optional<double> since_s) {
    const double step_s = time_s - before_s_;
    if (begun_ && step_s > 0 && since_s) {
      behind_N_ = behind_N_ * std::exp(-step_s / lag_s_) +
                  (force_N - last_N_) * std::exp(-*since_s / lag_s_);
    } else if (begun_ && step_s > 0) {
      const double settled_N = lag_s_ * (force_N - last_N_) / step_s;
      behind_N_ = settled_N + (behind_N_ - settled_N) * std::exp(-step_s / lag_s_);
    }
    begun_ = true;
    before_s_ = time_s;
    last_N_ = force_N;
    return force_N - behind_N_;
  }

 private:
  double lag_s_;
  bool begun_ = false;
  double before_s_ = 0;
  double last_N_ = 0;
  double behind_N_ = 0;
};

/// The time since the motion turned or set in, where it did since the sample before.
std::optional<double> since_reversal_s(const ForceRecord& record, std::size_t i) {
  const double before_m_s = record.velocity_m_s[i - 1];
  const double after_m_s = record.velocity_m_s[i];
  if (before_m_s * after_m_s > 0 || before_m_s == after_m_s) {
    return std::nullopt;
  }
  return (record.time_s[i] - record.time_s[i - 1]) * after_m_s / (after_m_s - before_m_s);
}

ForceValues values_of(const ForceTerms& terms, const ForceScales& scales,
                      std::span<const double> parameters) {
  ForceValues values;
  values.gain = parameters[0];
  values.friction = parameters[1];
  std::size_t next = 2;
  for (const ForceTerm term : terms) {
    const std::size_t count = parameters_of(term, scales).size();
    law_of(term).set(parameters.subspan(next, count), values);
    next += count;
  }
  return values;
}

void predict_in_time(const ForceRecord& record, const Kinematics& kinematics,
                     const ForceValues& values, const ForceScales& scales,
                     std::vector<double>& input_N) {
  input_N.resize(record.samples());
  if (input_N.empty()) {
    return;
  }
  const Forward forward(record, kinematics, values, scales);
  Slip slip(record, kinematics, values);
  Spring spring(record, forward, values);
  Lag lag(-values.lag_s);
  const bool at_once =
      values.stiffness_N_m == 0 && values.presliding_m == 0 && values.presliding_N_m == 0;
  for (std::size_t i = 0; i < record.samples(); ++i) {
    const Forward::Sample of = forward.sample(i);
    const Forward::Friction friction = forward.friction(of, std::abs(record.velocity_m_s[i]));
    const bool remembers = !at_once && i == 0;
    if (remembers) {
      slip.begin(forward.turned_at(i, of, friction));
    }
    slip.go_to(i, forward.presliding_m(of, friction));
    double held_N = 0;
    if (values.stiffness_N_m > 0 && i > 0) {
      spring.go_to(i, of, slip.loose());
      held_N = spring.held_N();
    } else {
      const double turned = remembers ? slip.turned() : slip.slip();
      held_N = forward.input_N(of, friction, turned, slip.loose());
      spring.begin(of, held_N, turned);
    }
    input_N[i] = forward.shown_N(i, held_N);
    if (values.lag_s < 0) {
      input_N[i] = lag.read(input_N[i], record.time_s[i],
                            at_once && i > 0 ? since_reversal_s(record, i) : std::nullopt);
    }
  }
}

}  // namespace

double step_of(const ForceParameter& parameter, double value) {
  constexpr double kFine = 1e-5;  // relative
  constexpr double kWide = 0.05;
  const double step = (parameter.stepped ? kWide : kFine) *
                      std::max(std::abs(value), std::abs(parameter.starts.front()));
  return value + step > parameter.maximum ? -step : step;
}

void predict_input(const ForceRecord& record, const Kinematics& kinematics, const ForceTerms& terms,
                   const ForceScales& scales, std::span<const double> parameters,
                   std::vector<double>& input_N) {
  const ForceValues values = values_of(terms, scales, parameters);
  if (values.delay_s == 0 || record.samples() < 2) {
    predict_in_time(record, kinematics, values, scales, input_N);
    return;
  }
  const auto [read, moved] = read_later(record, kinematics, scales, values.delay_s);
  predict_in_time(read, moved ? *moved : kinematics, values, scales, input_N);
}

bool position_slopes(const ForceRecord& record, const Kinematics& kinematics,
                     const ForceTerms& terms, const ForceScales& scales,
                     std::span<const double> parameters, std::span<const double> at_N,
                     std::size_t place, std::vector<double>& slopes_N) {
  if (terms[place] != ForceTerm::position && terms[place] != ForceTerm::position_from_middle) {
    return false;
  }
  ForceValues values = values_of(terms, scales, parameters);
  if (values.stiffness_N_m > 0 || values.presliding_N_m > 0 || values.lag_s < 0 ||
      values.delay_s != 0) {
    return false;
  }
  constexpr double kStep = 1e-6;
  std::vector<double> above_N;
  values.evenly = kStep;
  predict_in_time(record, kinematics, values, scales, above_N);
  slopes_N.clear();
  for (std::size_t i = 0; i < at_N.size(); ++i) {
    const double by_share_N = (above_N[i] - at_N[i]) / kStep;
    each_wave(kinematics, values.from_middle, i,
              [&](std::size_t, double wave) { slopes_N.push_back(wave * by_share_N); });
  }
  return true;
}

}  // namespace host_sim::effects
