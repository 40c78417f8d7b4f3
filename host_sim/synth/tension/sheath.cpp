#include "host_sim/synth/tension/sheath.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace host_sim::synth {
namespace {

// Far beyond what can be recorded, so that values that run away end there.
constexpr double kMostFriction = 1e3;
constexpr double kMost_N = 1e12;

constexpr int kPieces = 16;
constexpr int kBits = 40;
constexpr std::uintmax_t kMostSteps = 60;

double stiffness_of(Parts parts) {
  double compliance_m_N = 0;
  for (const auto& part : parts) {
    compliance_m_N += 1 / part->stiffness_N_m();
  }
  return 1 / compliance_m_N;
}

double friction(Parts parts, const Moment& moment, double mu, double tension_N) {
  for (const auto& part : parts) {
    mu = part->friction(mu, moment, tension_N);
  }
  return std::clamp(mu, 0.0, kMostFriction);
}

double along_sheath_N(Parts parts, const Moment& moment, double mu, double exponent_rad) {
  double tension_N = moment.output_tension_N;
  const double piece_rad = exponent_rad / kPieces;
  for (int i = 0; i < kPieces; ++i) {
    const double here = friction(parts, moment, mu, tension_N);
    const double middle_N = tension_N * std::exp(here * piece_rad / 2);
    tension_N *= std::exp(friction(parts, moment, mu, middle_N) * piece_rad);
  }
  return tension_N;
}

double state_after(Parts parts, double before, double direction, double slide_m) {
  double state = direction;
  for (const auto& part : parts) {
    state = part->friction_state(state, before, slide_m);
  }
  return state;
}

/// Where `excess` changes its sign between 0 and `end`; 0 where it is not negative there, `end`
/// where it is not positive there.
template <class Excess>
double root_between_0_and(double end, const Excess& excess) {
  const double at_low = excess(0.0);
  if (at_low >= 0) {
    return 0;
  }
  const double at_high = excess(end);
  if (at_high <= 0) {
    return end;
  }
  std::uintmax_t most_steps = kMostSteps;
  const boost::math::tools::eps_tolerance<double> tolerance(kBits);
  const auto bracket =
      boost::math::tools::toms748_solve(excess, 0.0, end, at_low, at_high, tolerance, most_steps);
  return (bracket.first + bracket.second) / 2;
}

}  // namespace

double tension_at_drive_N(Parts parts, const Moment& moment, double mu, double friction_state) {
  double angle_rad = moment.bend_angle_rad;
  bool along_sheath = false;
  for (const auto& part : parts) {
    angle_rad = part->bend_angle_rad(angle_rad, moment);
    along_sheath = along_sheath || part->along_sheath();
  }
  const double exponent_rad = std::max(0.0, angle_rad) * friction_state;
  const double output_N = moment.output_tension_N;
  double tension_N =
      along_sheath ? along_sheath_N(parts, moment, mu, exponent_rad)
                   : output_N * std::exp(friction(parts, moment, mu, output_N) * exponent_rad);
  for (const auto& part : parts) {
    tension_N = part->input_tension_N(tension_N, friction_state, moment);
  }
  return std::clamp(tension_N, 0.0, kMost_N);
}

double Contact::step(Parts parts, double mu, Moment& moment) {
  const double direction = moment.direction;
  const double travel_m = std::max(0.0, direction * moment.travel_m);
  const double stiffness = stiffness_of(parts);
  if (!std::isfinite(stiffness)) {
    moment.slide_m_s = moment.velocity_m_s;
    state_ = state_after(parts, state_, direction, direction * travel_m);
    return tension_at_drive_N(parts, moment, mu, state_);
  }
  if (moment.step_s <= 0) {
    moment.slide_m_s = 0;
    return tension_N_ = tension_at_drive_N(parts, moment, mu, state_);
  }
  const auto sliding_N = [&](double slid_m) {
    moment.slide_m_s = direction * slid_m / moment.step_s;
    return tension_at_drive_N(parts, moment, mu,
                              state_after(parts, state_, direction, direction * slid_m));
  };
  // Pulling, the tension climbs with the stretch until the contact slides; letting go, it falls.
  const double slid_m = root_between_0_and(travel_m, [&](double slide_m) {
    const double stretched_N = tension_N_ + direction * stiffness * (travel_m - slide_m);
    return direction * (sliding_N(slide_m) - stretched_N);
  });
  if (slid_m > 0) {
    tension_N_ = sliding_N(slid_m);
    state_ = state_after(parts, state_, direction, direction * slid_m);
    return tension_N_;
  }
  moment.slide_m_s = 0;
  const double stuck_N = tension_N_ + direction * stiffness * travel_m;
  const double slips_back_N = tension_at_drive_N(parts, moment, mu, -direction);
  tension_N_ = direction > 0 ? std::max(stuck_N, slips_back_N) : std::min(stuck_N, slips_back_N);
  return tension_N_;
}

}  // namespace host_sim::synth
