#include "host_sim/effects/tension/contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace host_sim::effects {
namespace {

/// Where what rises changes its sign between 0 and an end; 0 where it is not negative there, the
/// end where it is not positive there.
template <class Excess>
double root_between_0_and(double end, const Excess& excess) {
  constexpr int kMostSteps = 40;
  constexpr double kEnough = 1e-9;  // of what it rises by
  double low = 0;
  double at_low = excess(low);
  if (at_low >= 0) {
    return 0;
  }
  double high = end;
  double at_high = excess(high);
  if (at_high <= 0) {
    return end;
  }
  const double enough = kEnough * (at_high - at_low);
  // By secants, of which an end that stays counts half (Illinois).
  int kept = 0;
  double middle = end;
  for (int step = 0; step < kMostSteps; ++step) {
    middle = (low * at_high - high * at_low) / (at_high - at_low);
    const double at_middle = excess(middle);
    if (std::abs(at_middle) < enough) {
      break;
    }
    if (at_middle < 0) {
      low = middle;
      at_low = at_middle;
      at_high /= kept == -1 ? 2 : 1;
      kept = -1;
    } else {
      high = middle;
      at_high = at_middle;
      at_low /= kept == 1 ? 2 : 1;
      kept = 1;
    }
  }
  return middle;
}

/// Of the time since the sample before, when the motion turned; 1: it did not.
double turn_share(const ForceRecord& record, std::size_t i) {
  if (record.reversal_m[i] == record.position_m[i]) {
    return 1;
  }
  const double before_m_s = record.velocity_m_s[i - 1];
  const double after_m_s = record.velocity_m_s[i];
  constexpr double kMiddle = 0.5;  // it turned twice
  return before_m_s * after_m_s < 0 ? before_m_s / (before_m_s - after_m_s) : kMiddle;
}

}  // namespace

void Spring::go_to(std::size_t i, const Forward::Sample& of, bool loose) {
  before_ = std::exchange(now_, of);
  const double turned = turn_share(record_, i);
  const double step_s = record_.time_s[i] - record_.time_s[i - 1];
  const double reversal_m = record_.reversal_m[i];
  move_by({turned, loose}, reversal_m - record_.position_m[i - 1], turned * step_s);
  if (turned < 1) {
    move_by({1, loose}, record_.position_m[i] - reversal_m, (1 - turned) * step_s);
  }
}

double Spring::force_N(const Place& at, double turned, double speed_m_s) const {
  const auto of_sample_N = [&](const Forward::Sample& of) {
    return forward_.input_N(of, forward_.friction(of, speed_m_s), turned, at.loose);
  };
  return at.share < 1 ? std::lerp(of_sample_N(before_), of_sample_N(now_), at.share)
                      : of_sample_N(now_);
}

void Spring::move_by(const Place& at, double moved_m, double time_s) {
  const double stretched_N = held_N_ + stiffness_N_m_ * moved_m;
  if (at_once_ || moved_m == 0) {
    const auto [low_N, high_N] = std::minmax({force_N(at, -1, 0), force_N(at, 1, 0)});
    held_N_ = std::clamp(stretched_N, low_N, high_N);
    return;
  }
  const double side = moved_m > 0 ? 1 : -1;
  const double presliding_m = forward_.presliding_m(now_, forward_.friction(now_, 0));
  const auto sliding_N = [&](double slid_m) {
    return force_N(at, turned_further(turned_, side, slid_m, presliding_m), slid_m / time_s);
  };
  const double slid_m = root_between_0_and(std::abs(moved_m), [&](double slid) {
    return side * (sliding_N(slid) - stretched_N) + stiffness_N_m_ * slid;
  });
  if (slid_m > 0) {
    held_N_ = sliding_N(slid_m);
    turned_ = turned_further(turned_, side, slid_m, presliding_m);
  } else {
    const double back_N = force_N(at, -side, 0);
    held_N_ = side > 0 ? std::max(stretched_N, back_N) : std::min(stretched_N, back_N);
  }
}

}  // namespace host_sim::effects
