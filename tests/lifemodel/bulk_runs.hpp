#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "lifemodel/bulk/parallel_replay.hpp"
#include "lifemodel/bulk/replay.hpp"
#include "lifemodel/extension/life.hpp"
#include "support.hpp"

/// Random runs of the bulk replay beside push() and settle() of each sample.
namespace lifemodel_test {

using Random = std::mt19937;

inline double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
inline std::size_t below(Random& random, std::size_t count) {
  return random() % count;
}

/// Any law, hysteresis and extension that there can be.
inline lifemodel::extension::LifeParameters random_parameters(Random& random) {
  constexpr std::array kHystereses_N{0.0, 0.0, 0.2, 1.0, 5.0, 20.0, 60.0, 150.0};
  auto constants = paper_constants();
  constants.ipl_exponent =
      below(random, 2) == 0 ? 1 + static_cast<double>(below(random, 12)) : uniform(random, 1, 12);
  constants.ipl_scale = std::pow(10.0, static_cast<double>(below(random, 8))) *
                        std::pow(constants.ultimate_tension_N, constants.ipl_exponent);
  constants.hysteresis_N = kHystereses_N[below(random, kHystereses_N.size())];
  lifemodel::extension::Extension extension;
  if (below(random, 8) == 0) {
    extension.add(lifemodel::extension::Effect::mean_stress);
    extension.mean_stress = {.share = 1 << 27, .walker = 1 << 27};
  }
  return lifemodel::extension::life_parameters(parameters_of(constants), extension);
}

/// A signal of one of the kinds that have plateaus, ties, nested ranges, ranges of just the
/// hysteresis, and points that are noted one by one.
inline Signal random_signal(Random& random, lifemodel::TensionRange hysteresis) {
  constexpr std::array<std::size_t, 4> kMostSamples{300, 300, 3000, 40'000};
  const std::size_t samples = 1 + below(random, kMostSamples[below(random, 4)]);
  const double low_N = below(random, 12) == 0 ? -60 : 0;
  const double high_N = below(random, 12) == 0 ? 180 : below(random, 2) == 0 ? 100 : 170;
  const double step_N = std::pow(10.0, static_cast<double>(below(random, 4)) - 2);
  const double period = uniform(random, 5, 2000);
  const double noise_N = 0.3 * static_cast<double>(below(random, 3));
  const std::size_t levels = 2 + below(random, 12);
  const std::size_t turns = 30 * levels;  // of a spiral: beyond the capacity of the residue
  std::normal_distribution<double> normal;
  const std::size_t kind = below(random, 11);
  const std::uint32_t half = (hysteresis.raw() + 1) / 2;
  const std::size_t most_halves = std::min<std::size_t>(levels, (1u << 29) / half);
  const std::size_t nested = below(random, 40) + lifemodel::DefaultLayout::kResidue - 40;
  double tension_N = 50;
  Signal signal;
  for (std::size_t i = 0; i < samples; ++i) {
    const auto n = static_cast<double>(i);
    const double side = i % 2 == 0 ? 1 : -1;
    switch (kind) {
      case 0:
        tension_N = uniform(random, low_N, high_N);
        break;
      case 1:
        tension_N += step_N * normal(random);
        tension_N = tension_N > high_N ? 2 * high_N - tension_N : tension_N;
        tension_N = tension_N < low_N ? 2 * low_N - tension_N : tension_N;
        break;
      case 2:
        tension_N = (low_N + high_N) / 2 +
                    (high_N - low_N) * 0.49 * std::sin(n * 2 * M_PI / period) +
                    noise_N * normal(random);
        break;
      case 3:
        tension_N = low_N + (high_N - low_N) * static_cast<double>(below(random, levels)) /
                                static_cast<double>(levels);
        break;
      case 4:
        tension_N = std::clamp(tension_N + step_N * (static_cast<double>(below(random, 3)) - 1),
                               low_N, high_N);
        break;
      case 5:
        tension_N = 80 + side * (0.01 + 0.2 * static_cast<double>((samples - i) % turns));
        break;
      case 6:
        tension_N = 80 + side * 0.2 * static_cast<double>(i % turns);
        break;
      case 7:
        tension_N = below(random, 5) == 0 ? uniform(random, low_N, high_N) : tension_N;
        break;
      case 8:
        signal.push_back(lifemodel::Tension::from_raw(
            static_cast<std::int32_t>(half * below(random, most_halves))));
        continue;
      case 9:
        tension_N = i % 1000 < nested ? 80 + side * (70 - 0.5 * static_cast<double>(i % 1000))
                                      : uniform(random, 80, 81);
        break;
      default:
        tension_N = below(random, 50) == 0 ? uniform(random, low_N, high_N)
                                           : 50 + 5 * step_N * normal(random);
        break;
    }
    signal.push_back(newtons(tension_N));
  }
  return signal;
}

using BulkEstimator =
    lifemodel::Estimator<1, lifemodel::extension::ExtendedLife<lifemodel::DefaultLayout>>;

inline void push_each(BulkEstimator& estimator, std::span<const lifemodel::Tension> samples) {
  for (const lifemodel::Tension sample : samples) {
    estimator.push(0, sample);
    while (estimator.settle()) {
    }
  }
}

inline void push_late(BulkEstimator& estimator, std::span<const lifemodel::Tension> samples) {
  for (const lifemodel::Tension sample : samples) {
    estimator.push(0, sample);
  }
  estimator.flush(0);
}

/// The whole state, with nothing pending.
inline std::vector<std::byte> state_of(BulkEstimator& estimator) {
  estimator.flush(0);
  std::vector<std::byte> bytes(BulkEstimator::kSnapshotBytes);
  bytes.resize(estimator.snapshot(bytes).size());
  return bytes;
}

/// Takes the signal by these instructions: at once, by one or by several threads, or in parts of
/// random length, some of which are pushed one by one and some reduced however short they are.
inline void take_in_bulk(BulkEstimator& estimator, const lifemodel::bulk::Instructions& by,
                         std::span<const lifemodel::Tension> signal, Random& random) {
  using lifemodel::bulk::Reducer;
  lifemodel::bulk::Replay replay(by);
  const std::size_t whole = below(random, 8);
  if (whole < 3) {
    replay.take(estimator, 0, signal);
    return;
  }
  if (whole == 3) {
    const unsigned threads = 1 + static_cast<unsigned>(below(random, 4));
    constexpr std::array<std::size_t, 3> kMost{10, 100, 2000};
    const std::size_t stretch = 1 + below(random, kMost[below(random, kMost.size())]);
    lifemodel::bulk::ParallelReplay(threads, by, stretch).take(estimator, 0, signal);
    return;
  }
  Reducer reducer(by);
  const auto& parameters = estimator.parameters(0);
  while (!signal.empty()) {
    constexpr std::array<std::size_t, 3> kMost{20, 500, Reducer::kMostSamples};
    const auto part = signal.first(
        std::min(signal.size(), 1 + below(random, kMost[below(random, kMost.size())])));
    signal = signal.subspan(part.size());
    const std::size_t way = below(random, 3);
    if (way == 0) {
      replay.take(estimator, 0, part);
    } else if (way == 1 || part.size() > kMost[1]) {
      const auto stretch = reducer.reduce(part, parameters.hysteresis, parameters.law);
      if (!stretch || !estimator.replay(0, *stretch)) {
        push_each(estimator, part);
      }
    } else {
      push_each(estimator, part);
    }
  }
}

/// One run; the instructions whose state is another than that of push() and settle(), or nothing.
inline std::optional<std::string> difference(std::uint32_t seed) {
  Random random(seed);
  const auto parameters = random_parameters(random);
  const Signal signal = random_signal(random, parameters.hysteresis);
  // Some come faster than they are settled, before those that are counted in bulk.
  const Signal late(signal.begin(),
                    signal.begin() + static_cast<std::ptrdiff_t>(
                                         below(random, std::min<std::size_t>(signal.size(), 200))));
  BulkEstimator one_by_one({parameters});
  push_late(one_by_one, late);
  push_each(one_by_one, signal);
  const auto expected = state_of(one_by_one);
  for (const lifemodel::bulk::Instructions* by : lifemodel::bulk::instructions()) {
    BulkEstimator estimator({parameters});
    push_late(estimator, late);
    take_in_bulk(estimator, *by, signal, random);
    if (state_of(estimator) != expected) {
      return by->name;
    }
  }
  return std::nullopt;
}

}  // namespace lifemodel_test
