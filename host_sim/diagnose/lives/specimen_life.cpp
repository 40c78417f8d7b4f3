#include "host_sim/diagnose/lives/specimen_life.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
    cases_.push_back({damage_of(blocks, settings.sequence_exponent), limit.ln_weight});
  }
  if (settings.second_mode) {
    const LifeSettings::SecondMode& mode = *settings.second_mode;
    has_second_ = true;
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

double SpecimenLife::log_of(const Damage& damage, double shift, bool density) const {
  const double ln_damage = damage.ln - shift;
  double log_survival = -std::exp(shape_ * ln_damage);
  double ln_hazard = ln_shape_ + (shape_ - 1) * ln_damage + damage.ln_rate - shift;
  if (has_second_) {
    log_survival -= std::exp(second_shape_ * second_.ln);
    const double second =
        std::isfinite(second_.ln_rate)
            ? ln_second_shape_ + (second_shape_ - 1) * second_.ln + second_.ln_rate
            : -kForever;
    ln_hazard = log_sum(std::isfinite(damage.ln_rate) ? ln_hazard : -kForever, second);
  } else if (!std::isfinite(damage.ln_rate)) {
    ln_hazard = -kForever;
  }
  return density ? log_survival + ln_hazard : log_survival;
}

double SpecimenLife::log_mean(double shift, bool density) const {
  if (cases_.size() == 1) {
    return log_of(cases_.front().damage, shift, density);
  }
  double sum = 0;
  for (const Case& one : cases_) {
    sum += std::exp(one.ln_weight + log_of(one.damage, shift, density));
  }
  return sum > 0 ? std::log(sum) : -1e4;
}

double SpecimenLife::log_survival(double shift) const {
  if (!has_weak_) {
    return log_mean(shift, false);
  }
  return log_sum(ln_strong_ + log_mean(shift, false),
                 ln_weak_ + log_mean(shift + weak_shift_, false));
}

double SpecimenLife::log_likelihood(double shift) const {
  if (!failed_) {
    return log_survival(shift);
  }
  if (!has_weak_) {
    return log_mean(shift, true);
  }
  return log_sum(ln_strong_ + log_mean(shift, true),
                 ln_weak_ + log_mean(shift + weak_shift_, true));
}

double SpecimenLife::ln_damage() const {
  return cases_[cases_.size() / 2].damage.ln;
}

}  // namespace host_sim::diagnose::lives
