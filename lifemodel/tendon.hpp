#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/counting/queue.hpp"
#include "lifemodel/counting/rainflow.hpp"
#include "lifemodel/counting/stretch.hpp"
#include "lifemodel/counting/turning_points.hpp"
#include "lifemodel/quantity/units.hpp"
#include "lifemodel/state/ledger.hpp"
#include "lifemodel/support/bytes.hpp"
#include "lifemodel/support/inlining.hpp"

namespace lifemodel {

/// How much one tendon remembers.
struct DefaultLayout {
  static constexpr std::size_t kResidue = 128;  ///< turning points that nest
  static constexpr std::size_t kQueue = 32;     ///< turning points between push() and settle()
};

/// What is known about a tendon at one instant.
///
/// closed + open equals an off-line count of all samples so far that ends with this one, bit for
/// bit, however the samples were handed over. Tension held at the ultimate one from the first
/// sample on turns nowhere: its way up from no tension is then the half cycle that is open.
struct Reading {
  Damage closed;  ///< full cycles
  Damage open;    ///< half cycles of the residue, with the unconfirmed last turning point
  Damage total;
  Cycles closed_cycles;
  HalfCycles open_half_cycles;
  Flags flags;
  Events overloads;          ///< turning points, held tensions too, that reached the ultimate one
  Events negatives;          ///< the same below zero by more than the hysteresis
  Events residue_overflows;  ///< cycles counted larger than they were, see Residue
  Events overruns;           ///< cycles counted larger than they were, see Overrun
  Events gaps;
  MissingSamples missing_samples;
};

/// Hears of every cycle as it is counted; this one does not listen.
struct NoObserver {
  constexpr void full(Tension, Tension, CycleDamage) const {}
  constexpr void half(Tension, Tension, CycleDamage) const {}
};

/// What a layout knows of a tendon's model: its own `Parameters`, or those that there are.
template <class Layout>
struct ParametersOf {
  using Type = Parameters;
};
template <class Layout>
requires requires {
  typename Layout::Parameters;
}
struct ParametersOf<Layout> {
  using Type = typename Layout::Parameters;
};

/// The state of one tendon: a producer side for push(), a consumer side for everything else. They
/// share only the queue, the run of the filter and the overrun, so that push() may interrupt the
/// rest at any point.
template <class Layout = DefaultLayout>
class Tendon {
 public:
  using Model = typename ParametersOf<Layout>::Type;
  using Law = decltype(Model::law);

  /// Producer: one sample. Constant time. Returns how many turning points wait where it has found
  /// one, else 0.
  std::uint32_t push(Tension tension, const Model& parameters) {
    std::uint32_t waiting = 0;
    filter_.push(tension, parameters.hysteresis, [&](Tension turning_point) {
      const std::uint32_t free = queue_.free();
      if (overrun_.leaving_out() || free == 0) [[unlikely]] {
        waiting = put_late(turning_point, free);
      } else {
        queue_.put(turning_point);
        waiting = Layout::kQueue + 1 - free;
      }
    });
    return waiting;
  }

  /// Producer and consumer at once: many samples, each pushed and settled.
  /// @pre nothing is pending
  template <class Observer>
  void replay(std::span<const Tension> samples, const Model& parameters, Observer observer) {
    while (!samples.empty()) {
      std::size_t count = 1;
      if (filter_.directed() && !overrun_.leaving_out()) {
        count = std::min<std::size_t>(samples.size(), Layout::kQueue);
        fill_queue(samples.first(count), parameters.hysteresis);
      } else {
        push(samples.front(), parameters);
      }
      samples = samples.subspan(count);
      flush<kBatchCycles>(parameters, observer);
    }
  }

  /// The same of a stretch of samples of which the full cycles have been taken out. False, and
  /// nothing taken in, where the samples themselves might nest too deep.
  /// @pre nothing is pending
  bool replay(const Stretch& stretch, const Model& parameters) {
    // What the stretch does not know of: the candidate, and the extremes of an overrun.
    constexpr std::size_t kBefore = 8;
    static_assert(kBefore > Overrun::kPlaces);
    if (residue_.points().size() + stretch.nesting + kBefore > Layout::kResidue) {
      return false;
    }
    ledger_.closed.add(stretch.damage, ledger_.flags);
    ledger_.cycles.add(stretch.cycles, ledger_.flags);
    replay(stretch.left, parameters, NoObserver{});
    return true;
  }

  /// Producer: a gap of `samples` that are missing. The count continues across it with the next
  /// sample.
  void push_missing(std::uint32_t samples) { intake_.miss(samples); }

  [[nodiscard]] std::uint32_t waiting() const { return queue_.size(); }

  /// Producer: flags for conversions of samples on their way in.
  Flags& input_flags() { return intake_.flags; }

  /// Consumer: counts at most kCycles cycles and takes in at most twice as many turning points.
  template <std::uint32_t kCycles, class Observer>
  LIFEMODEL_ONE_COPY void settle(const Model& parameters, Observer observer) {
    if (paid_ != overrun_.owed()) [[unlikely]] {
      pay(parameters.law, observer);
      return;
    }
    std::array<FullCycle, kCycles> closed;
    Finals<Observer> finals{ledger_, parameters.law, observer};
    const auto waiting = queue_.range();
    const auto done = residue_.take(waiting, waiting.first, waiting.last,
                                    static_cast<std::int32_t>(2 * kCycles), closed.data(), finals);
    const std::uint32_t end = waiting.first + done.taken;
    for (std::uint32_t i = waiting.first; i != end; ++i) {
      note_extremes(waiting(i), parameters, ledger_.flags, ledger_.overloads, ledger_.negatives);
    }
    queue_.drop(done.taken);
    // While no turning point ever reached the ultimate tension, none has to be asked again.
    const bool overloaded = ledger_.overloads.raw() != 0;
    for (std::uint32_t i = 0; i < done.closed; ++i) {
      const Tension from = closed[i].from();
      const Tension to = closed[i].to();
      const CycleDamage damage =
          overloaded ? parameters.law(from, to) : parameters.law.below_ultimate(from, to);
      ledger_.closed.add(damage, ledger_.flags);
      observer.full(from, to, damage);
    }
    ledger_.cycles.add(done.closed, ledger_.flags);
  }

  /// Consumer: all that is pending.
  template <std::uint32_t kCycles, class Observer>
  void flush(const Model& parameters, Observer observer) {
    while (pending()) {
      settle<kCycles>(parameters, observer);
    }
  }

  /// Consumer: true while settle() has work. What an overrun owes comes before a turning point.
  [[nodiscard]] bool pending() const { return !queue_.empty(); }

  /// Consumer: reads; `observer` hears of the cycles that are in the reading but not counted for
  /// good. False, and no reading, where push() came in between. Time is bounded by the places of
  /// the residue.
  /// @pre nothing was pending
  template <class Observer>
  [[nodiscard]] bool read(const Model& parameters, Reading& r, Observer observer) const {
    const std::uint32_t started = filter_.lock().start();
    const Last last = this->last();
    const bool settled = !pending();
    if (!filter_.lock().unchanged(started) || !settled) {
      return false;
    }
    r = {};
    r.closed = ledger_.closed;
    r.open = ledger_.retired;
    r.closed_cycles = ledger_.cycles;
    r.open_half_cycles = ledger_.half_cycles;
    r.flags = intake_.flags.seen() | ledger_.flags;
    r.overloads = ledger_.overloads;
    r.negatives = ledger_.negatives;
    r.residue_overflows = ledger_.residue_overflows;
    r.overruns = ledger_.overruns;
    r.gaps = intake_.gaps.relaxed();
    r.missing_samples = intake_.missing_samples.relaxed();
    if (last.turns || CycleLaw::overloads(last.first)) {
      residue_.open(last.first, ReadingSink<Observer>{r, parameters.law, observer});
    }
    for (const Tension tension : {last.first, last.beyond}) {
      note_extremes(tension, parameters, r.flags, r.overloads, r.negatives);
    }
    r.total = r.closed;
    r.total.add(r.open, r.flags);
    return true;
  }

  /// Consumer: forgets the flags that counting has raised, as where the wire is a new one.
  void forget_flags() { ledger_.flags = {}; }

  static constexpr std::size_t kStoredBytes =
      4 * (4 + 7 + 1 + Intake::kWords + Ledger::kWords + 2 + Layout::kResidue + Layout::kQueue);

  /// Writes the state: at most kStoredBytes.
  void store(ByteWriter& out) const {
    const TurningPoints::State filter = filter_.state();
    out.u32(filter.phase);
    out.i32(filter.mirror);
    out.i32(filter.extremum);
    out.i32(filter.lowest);
    const Overrun::State overrun = overrun_.state();
    out.u32(overrun.length);
    out.u32(overrun.owed);
    out.u32(overrun.began_low);
    out.i32(overrun.run_lowest);
    out.i32(overrun.run_highest);
    out.i32(overrun.lowest);
    out.i32(overrun.highest);
    out.u32(paid_);
    intake_.store(out);
    ledger_.store(out);
    const auto points = residue_.points();
    out.u32(static_cast<std::uint32_t>(points.size()));
    out.u32(queue_.size());
    for (const Tension point : points) {
      out.i32(point.raw());
    }
    for (std::uint32_t i = 0; i < queue_.size(); ++i) {
      out.i32(queue_.at(i).raw());
    }
  }

  /// Reads a state; false if no count could have left it. Takes it up only if `replace`, which has
  /// to be tried with `replace` false before.
  bool load(ByteReader& in, bool replace) {
    TurningPoints::State filter{};
    filter.phase = in.u32();
    filter.mirror = in.i32();
    filter.extremum = in.i32();
    filter.lowest = in.i32();
    Overrun::State overrun{};
    overrun.length = in.u32();
    overrun.owed = in.u32();
    overrun.began_low = in.u32();
    overrun.run_lowest = in.i32();
    overrun.run_highest = in.i32();
    overrun.lowest = in.i32();
    overrun.highest = in.i32();
    const std::uint32_t paid = in.u32();
    Intake intake;
    Ledger ledger;
    const bool counts = intake.load(in) && ledger.load(in);
    const std::uint32_t residue_size = in.u32();
    const std::uint32_t queue_size = in.u32();
    if (in.failed() || !counts || !TurningPoints::plausible(filter) ||
        !Overrun::plausible(overrun, paid) || residue_size > Layout::kResidue ||
        queue_size > Layout::kQueue) {
      return false;
    }
    if (replace) {
      filter_.restore(filter);
      overrun_.restore(overrun);
      paid_ = paid;
      intake_ = intake;
      ledger_ = ledger;
      residue_.clear();
      queue_ = {};
    }
    return load_points(in, residue_size, queue_size, filter, overrun, replace);
  }

 private:
  static constexpr std::uint32_t kBatchCycles = 512;

  /// Books what take() reports beside the full cycles.
  template <class Observer>
  struct Finals {
    Ledger& ledger;
    const Law& law;
    Observer observer;

    void half(Tension from, Tension to) {
      const CycleDamage damage = law(from, to).half();
      ledger.retired.add(damage, ledger.flags);
      ledger.half_cycles.add(1, ledger.flags);
      observer.half(from, to, damage);
    }
    void overflow() {
      ledger.flags.raise(Flag::residue_overflow);
      ledger.residue_overflows.add(1, ledger.flags);
    }
  };

  template <class Observer>
  struct ReadingSink {
    Reading& reading;
    const Law& law;
    Observer& observer;

    void full(Tension from, Tension to) {
      const CycleDamage damage = law(from, to);
      reading.closed.add(damage, reading.flags);
      reading.closed_cycles.add(1, reading.flags);
      observer.full(from, to, damage);
    }
    void half(Tension from, Tension to) {
      const CycleDamage damage = law(from, to).half();
      reading.open.add(damage, reading.flags);
      reading.open_half_cycles.add(1, reading.flags);
      observer.half(from, to, damage);
    }
  };

  /// What came after all turning points that were queued, each no tension where there is none.
  struct Last {
    bool turns;      ///< there are such points, so that `first` is another
    Tension first;   ///< or what was held, where nothing has turned yet
    Tension beyond;  ///< after the first
  };

  [[nodiscard]] Last last() const {
    if (overrun_.running()) {
      return {true, overrun_.first_extreme(), filter_.run().candidate()};
    }
    if (filter_.directed()) {
      return {true, filter_.run().candidate(), {}};
    }
    return {false, filter_.held(), {}};
  }

  void fill_queue(std::span<const Tension> samples, TensionRange hysteresis) {
    typename TurningPointQueue<Layout::kQueue>::Batch batch(queue_);
    TurningPoints::Run run = filter_.run();
    for (const Tension sample : samples) {
      const Tension candidate = run.candidate();
      batch.put_if(run.turns(sample, hysteresis), candidate);
    }
    filter_.set_run(run);
  }

  /// `free` places were seen; there may be more by now, where settle() runs on another core.
  [[gnu::noinline]] std::uint32_t put_late(Tension turning_point, std::uint32_t free) {
    intake_.flags.raise(Flag::overrun);
    if (free < Overrun::kPlaces) {
      if (CycleLaw::overloads(turning_point)) {
        intake_.flags.raise(Flag::overload);
      }
      overrun_.leave_out(turning_point, turning_point < filter_.run().candidate());
    } else {
      overrun_.finish([&](Tension extreme) { queue_.put(extreme); });
      queue_.put(turning_point);
    }
    return Layout::kQueue - queue_.free();
  }

  /// Counts all cycles that overruns owe.
  template <class Observer>
  [[gnu::noinline]] void pay(const Law& law, Observer observer) {
    const std::uint32_t owed = overrun_.owed();
    const std::uint32_t times = owed - paid_;
    paid_ = owed;
    const Tension lowest = overrun_.lowest();
    const Tension highest = overrun_.highest();
    const CycleDamage damage = law(lowest, highest);
    ledger_.closed.add(damage, times, ledger_.flags);
    ledger_.cycles.add(times, ledger_.flags);
    ledger_.overruns.add(times, ledger_.flags);
    for (std::uint32_t i = 0; i < times; ++i) {
      observer.full(lowest, highest, damage);
    }
  }

  static void note_extremes(Tension turning_point, const Model& parameters, Flags& flags,
                            Events& overloads, Events& negatives) {
    // One comparison for both: nothing to note in -hysteresis .. ultimate tension.
    const std::uint32_t hysteresis = parameters.hysteresis.raw();
    if (static_cast<std::uint32_t>(turning_point.raw()) + hysteresis <
        static_cast<std::uint32_t>(kUltimate.raw()) + hysteresis) [[likely]] {
      return;
    }
    if (CycleLaw::overloads(turning_point)) {
      flags.raise(Flag::overload);
      overloads.add(1, flags);
    }
    if (turning_point.raw() < 0) {
      flags.raise(Flag::negative_tension);
      negatives.add(1, flags);
    }
  }

  /// Reads the residue and the queue and checks that they are what the rest of the state follows
  /// on.
  bool load_points(ByteReader& in, std::uint32_t residue_size, std::uint32_t queue_size,
                   const TurningPoints::State& filter, const Overrun::State& overrun,
                   bool replace) {
    Alternation alternation;
    TensionRange range = TensionRange::highest();
    Tension previous;
    for (std::uint32_t i = 0; i < residue_size + queue_size; ++i) {
      const auto point = Tension::checked(in.i32());
      if (in.failed() || !point || !alternation.next(*point)) {
        return false;
      }
      if (i < residue_size) {
        if (i > 0) {
          if (distance(previous, *point) > range) {
            return false;
          }
          range = distance(previous, *point);
        }
        previous = *point;
        if (replace) {
          residue_.append(*point);
        }
      } else if (replace) {
        queue_.put(*point);
      }
    }
    if (overrun.length != 0 && (alternation.empty() || !Overrun::extend(overrun, alternation))) {
      return false;
    }
    if (!TurningPoints::directed(filter)) {
      return alternation.empty();
    }
    const TurningPoints::Run run{filter.mirror, filter.extremum};
    return !alternation.empty() && alternation.next(run.candidate()) &&
           alternation.rising() == (filter.mirror == 0);
  }

  // Producer.
  TurningPoints filter_;
  Overrun overrun_;
  Intake intake_;
  // Shared.
  TurningPointQueue<Layout::kQueue> queue_;
  // Consumer.
  std::uint32_t paid_ = 0;
  Ledger ledger_;
  Residue<Layout::kResidue> residue_;
};

}  // namespace lifemodel
