#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "firmware/app/rates.hpp"
#include "firmware/protocol/messages.hpp"
#include "firmware/storage/life_record.hpp"
#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/life/advice.hpp"
#include "lifemodel/life/conditional.hpp"
#include "lifemodel/life/weibull.hpp"

namespace app {

/// What a drive may do so that the wire of one tendon lasts the hours of operation that are wanted,
/// at the risk that is accepted. It is told and never acted on.
///
/// The tension is that of the load of the last minute, scaled as a whole until its damage in the
/// operation that is left is the allowed one, at as many cycles. A drive that follows it has the
/// same advice again, because its cycles are still as many. The pace is relative to the heaviest
/// minute since the start, for the same reason: one relative to the last minute would rise as the
/// drive obeys.
class Derating {
 public:
  using State = protocol::AdviceState;

  /// What is wanted, and by which law.
  struct Terms {
    lifemodel::CycleLaw law{lifemodel::IplExponent::lowest(), 0};
    lifemodel::Tension least;  ///< tension with which a wire still pulls
    lifemodel::Ratio risk{};
    std::uint32_t until_s = 0;  ///< of operation of this wire; 0 is off

    static Terms of(const lifemodel::Parameters& parameters) {
      const lifemodel::WatchLimits& watch = parameters.watch;
      return {parameters.law, watch.minimum, watch.advice_risk, watch.advice_until_s};
    }
  };

  void resume(const Terms& terms) {
    terms_ = terms;
    begin();
  }
  /// A new wire.
  void begin() {
    state_ = terms_.until_s == 0 ? State::off : State::unknown;
    steady_ = {};
  }

  /// Whenever the rates are new.
  [[gnu::noinline]] void take(lifemodel::WeibullShape shape, const Rates& rates,
                              const storage::LifeRecord& record) {
    if (terms_.until_s == 0 || !rates.known()) {
      return;
    }
    const std::uint32_t operated_s = record.history.operated_s;
    if (operated_s >= terms_.until_s) {
      state_ = State::over;
      steady_.take({});
      return;
    }
    const std::uint32_t left_min = (terms_.until_s - operated_s - 1) / 60 + 1;
    const lifemodel::Damage allowed =
        lifemodel::further_damage(shape, record.epoch_damage, lifemodel::Hazard::of(terms_.risk));
    const lifemodel::Damage each = rates.damage_per_min();
    const lifemodel::Damage needed = each.multiplied(left_min);
    lifemodel::Advice advice =
        lifemodel::advise(terms_.law, allowed, needed, cycle_of(rates, each));
    if (needed <= allowed) {
      state_ = State::no_limit;
    } else {
      state_ = advice.tension.raw() <= least() ? State::unreachable : State::limited;
    }
    advice.pace = lifemodel::pace(allowed, rates.heaviest_per_min().multiplied(left_min));
    steady_.take(advice);
  }

  [[nodiscard]] State state() const { return state_; }
  /// Where the state is neither off nor unknown.
  [[nodiscard]] const lifemodel::Advice& advice() const { return steady_.advice(); }

 private:
  /// The load of the last minute.
  [[nodiscard]] lifemodel::RepresentativeCycle cycle_of(const Rates& rates,
                                                        const lifemodel::Damage& each) const {
    if (each.none()) {
      return {};
    }
    constexpr std::uint64_t kMost = 0xffff'ffff;
    const auto cycles =
        static_cast<std::uint32_t>(std::clamp<std::uint64_t>(rates.cycles_of_min(), 1, kMost));
    return lifemodel::RepresentativeCycle::of(
        terms_.law,
        lifemodel::numeric::quotient(lifemodel::normalise(each),
                                     lifemodel::numeric::normal(cycles, 0)),
        lifemodel::Tension::from_raw(static_cast<std::int32_t>(rates.peak())));
  }
  /// The tension below which a wire does not pull, or one that the page cannot tell, Q30.
  [[nodiscard]] std::uint32_t least() const {
    constexpr std::uint32_t kStep =
        lifemodel::Ratio::highest().raw() / protocol::detail::Advice::kWhole;
    return std::max(static_cast<std::uint32_t>(terms_.least.raw()) << 1, kStep);
  }

  Terms terms_;
  lifemodel::SteadyAdvice steady_;
  State state_ = State::off;
};

}  // namespace app
