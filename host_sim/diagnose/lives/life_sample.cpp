#include "host_sim/diagnose/lives/life_sample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace host_sim::diagnose::lives {
namespace {

constexpr double kNextLevel = 0.03;
constexpr double kSameLoad = 1e-6;

std::size_t number_of(const std::vector<std::string>& sorted, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::lower_bound(sorted, name) - sorted.begin());
}

std::vector<std::string> distinct(std::vector<std::string> names) {
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

void number_levels(LifeSample& sample) {
  std::vector<double> tensions_N;
  for (const LifeSample::Specimen& specimen : sample.specimens) {
    for (const LifeSample::Block& block : specimen.blocks) {
      tensions_N.push_back(block.effective_N);
    }
  }
  if (tensions_N.empty()) {
    return;
  }
  std::ranges::sort(tensions_N);
  sample.lowest_N = tensions_N.front();
  sample.highest_N = tensions_N.back();
  std::vector<double> firsts;
  for (const double tension_N : tensions_N) {
    if (firsts.empty() || tension_N > firsts.back() * (1 + kNextLevel)) {
      firsts.push_back(tension_N);
    }
  }
  for (LifeSample::Specimen& specimen : sample.specimens) {
    for (LifeSample::Block& block : specimen.blocks) {
      const auto after = std::ranges::upper_bound(firsts, block.effective_N);
      block.level = static_cast<std::size_t>(after - firsts.begin()) - 1;
    }
  }
  sample.levels = firsts.size();
}

bool same(double one, double other) {
  return std::abs(one - other) <= kSameLoad * (1 + std::abs(one));
}

void number_loads(LifeSample& sample) {
  std::vector<LifeSample::Block> loads;
  for (LifeSample::Specimen& specimen : sample.specimens) {
    specimen.load = LifeSample::kNoLoad;
    if (specimen.blocks.size() == 1) {
      const LifeSample::Block& block = specimen.last();
      const auto found = std::ranges::find_if(loads, [&](const LifeSample::Block& load) {
        return same(load.mean_N, block.mean_N) && same(load.amplitude_N, block.amplitude_N);
      });
      specimen.load = static_cast<std::size_t>(found - loads.begin());
      if (found == loads.end()) {
        loads.push_back(block);
      }
    }
  }
  sample.loads = loads.size();
  constexpr std::size_t kLeastSpecimens = 4;
  if (sample.loads * kLeastSpecimens > sample.size()) {
    sample.loads = sample.levels;
    for (LifeSample::Specimen& specimen : sample.specimens) {
      specimen.load = specimen.blocks.size() == 1 ? specimen.last().level : LifeSample::kNoLoad;
    }
  }
}

/// The ratio of the specimens under one load alone; nothing where there is none, or more than one.
std::optional<double> ratio_under(const LifeSample& sample, const LifeSample::Block& load) {
  std::optional<double> ratio;
  for (const LifeSample::Specimen& specimen : sample.specimens) {
    const LifeSample::Block& block = specimen.last();
    if (specimen.blocks.size() == 1 && same(block.mean_N, load.mean_N) &&
        same(block.amplitude_N, load.amplitude_N)) {
      if (ratio && *ratio != block.wire_to_bend_ratio) {
        return std::nullopt;
      }
      ratio = block.wire_to_bend_ratio;
    }
  }
  return ratio;
}

void give_ratios_to_later_blocks(LifeSample& sample) {
  for (LifeSample::Specimen& specimen : sample.specimens) {
    for (std::size_t j = 1; j < specimen.blocks.size(); ++j) {
      LifeSample::Block& block = specimen.blocks[j];
      block.wire_to_bend_ratio = ratio_under(sample, block).value_or(block.wire_to_bend_ratio);
    }
  }
}

LifeSample::Specimen specimen_of(const Campaign::Specimen& from) {
  LifeSample::Specimen specimen;
  specimen.name = from.name;
  specimen.lot = from.lot;
  specimen.failed = from.status == Campaign::Status::failed;
  specimen.days = from.days ? *from.days : 0;
  for (const Campaign::Block& block : from.blocks) {
    specimen.blocks.push_back({.mean_N = block.load.input_tension_mean_N,
                               .amplitude_N = block.load.input_tension_amplitude_N,
                               .effective_N = block.load.effective_tension_N,
                               .cycles = block.cycles,
                               .level = 0,
                               .wire_to_bend_ratio = from.wire_to_bend_ratio.value_or(0)});
  }
  if (specimen.blocks.size() > 1) {
    const bool falls = specimen.blocks.front().effective_N > specimen.last().effective_N;
    specimen.order = falls ? LifeSample::Order::falling : LifeSample::Order::rising;
  }
  return specimen;
}

}  // namespace

double LifeSample::Specimen::cycles() const {
  double sum = 0;
  for (const Block& block : blocks) {
    sum += block.cycles;
  }
  return sum;
}

std::size_t LifeSample::failures() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(specimens, [](const Specimen& specimen) { return specimen.failed; }));
}

LifeSample LifeSample::with(const std::vector<std::size_t>& kept) const {
  LifeSample part = *this;
  part.specimens.clear();
  for (const std::size_t i : kept) {
    part.specimens.push_back(specimens[i]);
  }
  return part;
}

LifeSample sample_of(const Campaign& campaign, Campaign::Role role) {
  LifeSample sample;
  sample.has_days = true;
  sample.has_ratios = true;
  std::vector<std::string> lots;
  std::vector<std::string> groups;
  std::vector<std::string> group_of;
  for (const Campaign::Specimen& from : campaign.specimens) {
    if (from.role != role) {
      continue;
    }
    sample.specimens.push_back(specimen_of(from));
    sample.has_days = sample.has_days && from.days;
    sample.has_ratios = sample.has_ratios && from.wire_to_bend_ratio;
    lots.push_back(from.lot);
    group_of.push_back(from.group);
  }
  lots = distinct(std::move(lots));
  groups = distinct(group_of);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    sample.specimens[i].lot_number = number_of(lots, sample.specimens[i].lot);
    sample.specimens[i].group = number_of(groups, group_of[i]);
  }
  sample.lots = lots.size();
  sample.groups = groups.size();
  sample.ultimate_tension_N = campaign.nominal.cable ? campaign.nominal.cable->ultimate_tension_N
                                                     : std::numeric_limits<double>::infinity();
  sample.nominal = campaign.nominal.life;
  number_levels(sample);
  number_loads(sample);
  if (sample.has_ratios) {
    give_ratios_to_later_blocks(sample);
  }
  sample.reference = std::make_shared<const std::vector<LifeSample::Specimen>>(sample.specimens);
  return sample;
}

}  // namespace host_sim::diagnose::lives
