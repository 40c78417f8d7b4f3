#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "hal/clock.hpp"
#include "hal/fake/random.hpp"

namespace hal::fake {

/// When a fake misbehaves and how: the first rule that applies to a call decides. `WhatT` is what
/// the fake can do wrong, an Error where that says it all.
///
///   Faults<Error> faults(seed);
///   faults.during(seconds(1), seconds(2), Error::failed).on_calls(7, 1, Error::missing);
template <class WhatT, std::size_t kRules = 8>
class Faults {
 public:
  using What = WhatT;

  constexpr Faults() = default;
  /// `seed` decides which calls at_random() hits.
  constexpr explicit Faults(std::uint64_t seed) : random_(seed) {}

  /// From this time on and before that one.
  constexpr Faults& during(Time from, Time before, What what) {
    return add({RuleKind::time, from.us, before.us, what});
  }
  /// `count` calls, after `first` others.
  constexpr Faults& on_calls(std::uint64_t first, std::uint64_t count, What what) {
    return add({RuleKind::calls, first, first + count, what});
  }
  /// Each call with this probability in millionths.
  constexpr Faults& at_random(std::uint32_t probability_ppm, What what) {
    return add({RuleKind::random, 0, probability_ppm, what});
  }
  /// From now on all is well. Calls are counted on.
  constexpr void clear() { rules_ = 0; }

  /// The fault of this call, which is counted.
  [[nodiscard]] constexpr std::optional<What> next(Time now) {
    const std::uint64_t call = calls_++;
    for (std::size_t i = 0; i < rules_; ++i) {
      if (applies(all_[i], now, call)) {
        ++faults_;
        return all_[i].what;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] constexpr std::uint64_t calls() const { return calls_; }
  [[nodiscard]] constexpr std::uint64_t faults() const { return faults_; }

 private:
  enum class RuleKind : std::uint8_t { time, calls, random };
  struct Rule {
    RuleKind kind;
    std::uint64_t from;
    std::uint64_t before;
    What what;
  };

  constexpr Faults& add(Rule rule) {
    if (rules_ == kRules) {
      __builtin_trap();
    }
    all_[rules_++] = rule;
    return *this;
  }

  constexpr bool applies(const Rule& rule, Time now, std::uint64_t call) {
    switch (rule.kind) {
      case RuleKind::time:
        return rule.from <= now.us && now.us < rule.before;
      case RuleKind::calls:
        return rule.from <= call && call < rule.before;
      case RuleKind::random:
        return random_.below(1'000'000) < rule.before;
    }
    return false;
  }

  std::array<Rule, kRules> all_{};
  std::size_t rules_ = 0;
  Random random_{1};
  std::uint64_t calls_ = 0;
  std::uint64_t faults_ = 0;
};

}  // namespace hal::fake
