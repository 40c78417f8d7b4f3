#pragma once

#include "lifemodel/damage/damage.hpp"
#include "lifemodel/quantity/flags.hpp"
#include "lifemodel/quantity/units.hpp"
#include "lifemodel/support/bytes.hpp"
#include "lifemodel/support/shared_word.hpp"

namespace lifemodel {

/// What push() has noticed about the samples of one tendon. A reading may be taken meanwhile.
struct Intake {
  Flags flags;
  SharedWord<Events> gaps;
  SharedWord<MissingSamples> missing_samples;

  void miss(std::uint32_t samples) {
    flags.raise(Flag::gap);
    add(gaps, 1);
    add(missing_samples, samples);
  }

  static constexpr std::size_t kWords = 3;
  constexpr void store(ByteWriter& out) const {
    out.u32(flags.bits());
    out.u32(gaps.own().raw());
    out.u32(missing_samples.own().raw());
  }
  /// False if nothing could have stored it.
  constexpr bool load(ByteReader& in) {
    const std::uint32_t bits = in.u32();
    flags = Flags::from_bits(bits);
    gaps = SharedWord(Events::from_raw(in.u32()));
    missing_samples = SharedWord(MissingSamples::from_raw(in.u32()));
    return (bits & ~kAllFlags) == 0;
  }

 private:
  template <class Counter>
  void add(SharedWord<Counter>& counter, std::uint32_t n) {
    Counter grown = counter.own();
    grown.add(n, flags);
    counter.set_plain(grown);
  }
};

/// What settle() has counted of one tendon, for good.
struct Ledger {
  Flags flags;
  Events overloads;          ///< turning points that reached the ultimate tension
  Events negatives;          ///< turning points below zero by more than the hysteresis
  Events residue_overflows;  ///< cycles counted larger than they were, see Residue
  Events overruns;           ///< cycles counted larger than they were, see Overrun
  Cycles cycles;
  HalfCycles half_cycles;  ///< final ones, from the start of the residue
  Damage closed;           ///< of full cycles
  Damage retired;          ///< of final half cycles

  static constexpr std::size_t kWords = 17;
  constexpr void store(ByteWriter& out) const {
    out.u32(flags.bits());
    out.u32(overloads.raw());
    out.u32(negatives.raw());
    out.u32(residue_overflows.raw());
    out.u32(overruns.raw());
    out.u64(cycles.raw());
    out.u64(half_cycles.raw());
    store(out, closed);
    store(out, retired);
  }
  /// False if nothing could have stored it.
  constexpr bool load(ByteReader& in) {
    const std::uint32_t bits = in.u32();
    flags = Flags::from_bits(bits);
    overloads = Events::from_raw(in.u32());
    negatives = Events::from_raw(in.u32());
    residue_overflows = Events::from_raw(in.u32());
    overruns = Events::from_raw(in.u32());
    cycles = Cycles::from_raw(in.u64());
    half_cycles = HalfCycles::from_raw(in.u64());
    closed = load_damage(in);
    retired = load_damage(in);
    return (bits & ~kAllFlags) == 0;
  }

 private:
  static constexpr void store(ByteWriter& out, const Damage& damage) {
    for (const std::uint32_t word : damage.words()) {
      out.u32(word);
    }
  }
  static constexpr Damage load_damage(ByteReader& in) {
    Damage::Words words{};
    for (std::uint32_t& word : words) {
      word = in.u32();
    }
    return Damage::from_words(words);
  }
};

}  // namespace lifemodel
