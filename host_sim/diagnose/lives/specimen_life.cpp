#include "host_sim/diagnose/lives/specimen_life.hpp"

#include <algorithm>
#include <boost/math/special_functions/expint.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "host_sim/diagnose/lives/life_settings.hpp"
#include "host_sim/diagnose/lives/quadrature.hpp"

namespace host_sim::diagnose::lives {
namespace {

Damage miner(std::span<const LoadedBlock> blocks) {
  double sum = 0;
  for (const LoadedBlock& block : blocks) {
    sum += block.cycles * std::exp(-block.ln_life);
  }
  return {.ln = sum > 0 ? std::log(sum) : -std::numeric_limits<double>::infinity(),
          .ln_rate = -blocks.back().ln_life};
}

/// Share of life that is spent at a strength, with its slope in ln of the strength.
struct Spent {
  double share = 0;
  double slope = 0;
};

Spent spent(std::span<const LoadedBlock> blocks, double exponent, double ln_strength) {
  Spent result;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (i > 0 && result.share > 0) {
      const double power = std::exp(exponent * (blocks[i - 1].ln_life - blocks[i].ln_life));
      const double carried = std::pow(result.share, power);
      result.slope *= power * carried / result.share;
      result.share = carried;
    }
    const double used = blocks[i].cycles * std::exp(-blocks[i].ln_life - ln_strength);
    result.share += used;
    result.slope -= used;
  }
  return result;
}

constexpr double kForever = std::numeric_limits<double>::infinity();

/// What shifts ln alpha of a block, whatever its tension.
double shift_of(const LifeSample::Specimen& specimen, const LifeSettings& settings) {
  double shift = (settings.day_shift - settings.ageing_1_day) * specimen.days;
  if (!settings.load_shift.empty() && specimen.load != LifeSample::kNoLoad) {
    shift += settings.load_shift[specimen.load];
  }
  if (specimen.order != LifeSample::Order::constant) {
    const bool falls = specimen.order == LifeSample::Order::falling;
    shift += falls ? settings.falling_shift : settings.rising_shift;
  }
  return shift;
}

/// -ln of the median of a Weibull strength, times its shape: -ln(ln 2).
constexpr double kLogMedian = 0.36651292058166433;

/// Of a lognormal strength with the median and the standard deviation of ln of a Weibull one.
SpecimenLife::Risk lognormal_risk(double ln_damage, double shape) {
  const double sd = kLogLifeSd / shape;
  const double z = (ln_damage + kLogMedian / shape) / sd;
  constexpr double kFar = 30;  // the tail beyond is that of its leading term
  const double log_survival = z > kFar ? -z * z / 2 - std::log(z * std::sqrt(2 * std::numbers::pi))
                                       : std::log(std::erfc(z / std::numbers::sqrt2) / 2);
  return {log_survival,
          -z * z / 2 - std::log(sd * std::sqrt(2 * std::numbers::pi)) - ln_damage - log_survival};
}

/// What one limit makes of a specimen: x = beta ln D, e^x and the survival exp(-e^x).
struct LimitNode {
  double x = -kForever, power = 0, survival = 1;
};

LimitNode node_of(double x) {
  const double power = std::exp(x);
  return {.x = x, .power = power, .survival = std::exp(-power)};
}

/// Integral of exp(-e^x) from x on, plus x where that is large.
double survival_beyond(const LimitNode& node) {
  constexpr double kAllFailed = 6.5;
  constexpr double kNoneFailed = -7;
  if (node.x > kAllFailed) {
    return 0;
  }
  return node.x < kNoneFailed ? node.power - std::numbers::egamma - node.x
                              : boost::math::expint(1, node.power);
}

/// By how much x falls between two limits at most.
constexpr double kFall = 6;

/// Means over the limits between two, of the survival and of its slope -dS/dx. x is taken to be
/// straight between them, so that it does not matter how much lives differ from one to the next,
/// and to fall by so much at most that nothing fails: at the load it falls without end.
double mean_survival(const LimitNode& near, const LimitNode& far) {
  const double fall = near.x - far.x;
  constexpr double kFlat = 1e-4;
  return std::abs(fall) < kFlat ? (near.survival + far.survival) / 2
                                : (survival_beyond(far) - survival_beyond(near)) / fall;
}

double mean_slope(const LimitNode& near, const LimitNode& far) {
  const double fall = near.x - far.x;
  constexpr double kFlat = 1e-4;
  return std::abs(fall) < kFlat ? (near.power * near.survival + far.power * far.survival) / 2
                                : (far.survival - near.survival) / fall;
}

bool reaches(const LifeSettings::SecondMode& mode, std::size_t level) {
  return level >= mode.first_level && level <= mode.last_level;
}

}  // namespace

Damage damage_of(std::span<const LoadedBlock> blocks, double sequence_exponent) {
  if (blocks.size() == 1) {
    const LoadedBlock& block = blocks.front();
    return {.ln = std::log(block.cycles) - block.ln_life, .ln_rate = -block.ln_life};
  }
  const Damage damage = miner(blocks);
  bool finite = std::isfinite(damage.ln);
  for (const LoadedBlock& block : blocks) {
    finite = finite && std::isfinite(block.ln_life);
  }
  if (sequence_exponent == 0 || !finite) {
    return damage;
  }
  double low = damage.ln - 1;
  double high = damage.ln + 1;
  while (spent(blocks, sequence_exponent, low).share < 1) {
    low -= 2;
  }
  while (spent(blocks, sequence_exponent, high).share > 1) {
    high += 2;
  }
  double at = damage.ln;
  Spent now = spent(blocks, sequence_exponent, at);
  constexpr int kSteps = 100;
  constexpr double kClose = 1e-13;
  for (int step = 0; step < kSteps && std::abs(now.share - 1) > kClose; ++step) {
    (now.share > 1 ? low : high) = at;
    const double newton = at - std::log(now.share) * now.share / now.slope;
    at = newton > low && newton < high ? newton : (low + high) / 2;
    now = spent(blocks, sequence_exponent, at);
  }
  // A cycle more adds 1/(w alpha) to the share; the strength makes up for it.
  return {.ln = at, .ln_rate = -blocks.back().ln_life - std::log(-now.slope)};
}

double log_sum(double one, double other) {
  const double large = std::max(one, other);
  if (large == -kForever) {
    return large;
  }
  return large + std::log1p(std::exp(std::min(one, other) - large));
}

LifeFrame frame_of(const LifeSample& sample, const LifeSettings& settings) {
  LifeFrame frame;
  frame.ln_centre_N = centre_ln_N(sample, settings);
  const double centre_N = std::exp(frame.ln_centre_N);
  constexpr double kLeastLeft = 1e-6;
  frame.ln_scale =
      settings.ln_life_at_centre +
      settings.exponent * std::log(std::max(centre_N - settings.limit_N, kLeastLeft * centre_N));
  if (settings.limit_N > 0 && settings.limit_log_sd > 0) {
    for (const NormalNode& node : even_nodes()) {
      frame.limits.push_back(
          {settings.limit_N * std::exp(settings.limit_log_sd * node.at), node.ln_weight});
    }
  } else {
    frame.limits.push_back({settings.limit_N, 0});
  }
  return frame;
}

SpecimenLife::SpecimenLife(const LifeSample& sample, const LifeSample::Specimen& specimen,
                           const LifeSettings& settings, const LifeFrame& frame)
    : failed_(specimen.failed) {
  ln_shape_ = std::log(settings.shape);
  if (!settings.level_log_shape.empty()) {
    ln_shape_ += settings.level_log_shape[specimen.last().level];
  }
  shape_ = std::exp(ln_shape_);
  lognormal_ = settings.lognormal;
  if (settings.weak_share > 0) {
    has_weak_ = true;
    ln_strong_ = std::log1p(-settings.weak_share);
    ln_weak_ = std::log(settings.weak_share);
    weak_shift_ = std::log(settings.weak_life_left);
  }
  add_cases(sample, specimen, settings, frame);
}

void SpecimenLife::add_cases(const LifeSample& sample, const LifeSample::Specimen& specimen,
                             const LifeSettings& settings, const LifeFrame& frame) {
  std::vector<LoadedBlock> blocks(specimen.blocks.size());
  std::vector<double> tensions_N(specimen.blocks.size());
  const double shift = shift_of(specimen, settings);
  for (std::size_t j = 0; j < blocks.size(); ++j) {
    tensions_N[j] = damaging_N(sample, specimen.blocks[j], settings);
    blocks[j].cycles = specimen.blocks[j].cycles;
  }
  cases_.reserve(frame.limits.size());
  for (const LifeFrame::Limit& limit : frame.limits) {
    for (std::size_t j = 0; j < blocks.size(); ++j) {
      const double left_N = tensions_N[j] - limit.limit_N;
      blocks[j].ln_life =
          left_N > 0 ? frame.ln_scale + shift - settings.exponent * std::log(left_N) : kForever;
    }
    const Damage damage = damage_of(blocks, settings.sequence_exponent);
    cases_.push_back({damage, std::exp(limit.ln_weight), std::exp(damage.ln_rate - damage.ln)});
  }
  if (settings.second_mode) {
    const LifeSettings::SecondMode& mode = *settings.second_mode;
    has_second_ = true;
    competes_ = mode.share == 0;
    ln_first_share_ = std::log1p(-mode.share);
    ln_second_share_ = std::log(mode.share);
    second_shape_ = mode.shape;
    ln_second_shape_ = std::log(mode.shape);
    const double ln_own = settings.ln_life_at_centre + settings.exponent * frame.ln_centre_N;
    for (std::size_t j = 0; j < blocks.size(); ++j) {
      const double away = std::abs(std::log(specimen.blocks[j].effective_N / mode.end_N));
      blocks[j].ln_life = reaches(mode, specimen.blocks[j].level)
                              ? ln_own - settings.exponent * std::log(tensions_N[j]) +
                                    mode.log_life_shift + mode.steepness * away
                              : kForever;
    }
    second_ = damage_of(blocks, 0);
  }
}

SpecimenLife::Risk SpecimenLife::first_risk(const Damage& damage, double shift) const {
  const double ln_damage = damage.ln - shift;
  Risk risk = lognormal_
                  ? lognormal_risk(ln_damage, shape_)
                  : Risk{-std::exp(shape_ * ln_damage), ln_shape_ + (shape_ - 1) * ln_damage};
  risk.ln_hazard =
      std::isfinite(damage.ln_rate) ? risk.ln_hazard + damage.ln_rate - shift : -kForever;
  return risk;
}

SpecimenLife::Risk SpecimenLife::second_risk() const {
  const double ln_hazard = ln_second_shape_ + (second_shape_ - 1) * second_.ln + second_.ln_rate;
  return {-std::exp(second_shape_ * second_.ln),
          std::isfinite(second_.ln_rate) ? ln_hazard : -kForever};
}

double SpecimenLife::log_of(const Damage& damage, double shift, bool density) const {
  Risk risk = first_risk(damage, shift);
  if (has_second_ && competes_) {
    const Risk second = second_risk();
    risk.log_survival += second.log_survival;
    risk.ln_hazard = log_sum(risk.ln_hazard, second.ln_hazard);
  }
  return risk.log(density);
}

double SpecimenLife::log_mean(double shift, bool density) const {
  if (cases_.size() == 1) {
    return log_of(cases_.front().damage, shift, density);
  }
  const bool competes = has_second_ && competes_;
  double survival = 0;
  double failing = 0;
  LimitNode near = node_of(shape_ * (cases_.front().damage.ln - shift));
  for (std::size_t i = 1; i < cases_.size(); ++i) {
    const double weight = (cases_[i - 1].weight + cases_[i].weight) / 2;
    if (!std::isfinite(near.x)) {
      survival += weight;
      near = node_of(shape_ * (cases_[i].damage.ln - shift));
      continue;
    }
    const double x = shape_ * (cases_[i].damage.ln - shift);
    const LimitNode far = node_of(std::max(x, near.x - kFall * shape_));
    if (!density || competes) {
      survival += weight * mean_survival(near, far);
    }
    if (density) {
      failing += weight * cases_[i - 1].rate_of_damage * shape_ * mean_slope(near, far);
    }
    near = x == far.x ? far : node_of(x);
  }
  const Risk second = competes ? second_risk() : Risk{0, -kForever};
  const double mean = density ? failing + std::exp(second.ln_hazard) * survival : survival;
  constexpr double kNone = -1e4;
  return second.log_survival + (mean > 0 ? std::log(mean) : kNone);
}

double SpecimenLife::log_mixed(double shift, bool density) const {
  double mixed = log_mean(shift, density);
  if (has_weak_) {
    mixed = log_sum(ln_strong_ + mixed, ln_weak_ + log_mean(shift + weak_shift_, density));
  }
  if (has_second_ && !competes_) {
    mixed = log_sum(ln_first_share_ + mixed, ln_second_share_ + second_risk().log(density));
  }
  return mixed;
}

double SpecimenLife::log_survival(double shift) const {
  return log_mixed(shift, false);
}

double SpecimenLife::log_likelihood(double shift) const {
  return log_mixed(shift, failed_);
}

double SpecimenLife::ln_damage() const {
  return cases_[cases_.size() / 2].damage.ln;
}

}  // namespace host_sim::diagnose::lives
