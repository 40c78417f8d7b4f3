#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/state/snapshot.hpp"
#include "lifemodel/tendon.hpp"

namespace lifemodel {

/// The life estimator of one actuator with `kTendons` tendons.
///
/// push() belongs into the control loop or its interrupt, settle() anywhere below it, reading() and
/// snapshots at leisure. Nothing allocates, throws, waits or takes the time; indices are not
/// checked.
///
///   const bool due = estimator.push(0, tension);  // in the interrupt
///   if (due) estimator.settle();                  // after it, or in the idle loop
///   auto used = estimator.reading(0);             // when somebody asks
template <std::size_t kTendons = 1, class LayoutT = DefaultLayout>
class Estimator {
 public:
  using Layout = LayoutT;
  using Model = typename ParametersOf<Layout>::Type;
  static constexpr std::size_t tendons() { return kTendons; }

  explicit Estimator(const std::array<Model, kTendons>& parameters) {
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      channels_[tendon].parameters = parameters[tendon];
    }
  }

  /// Takes one sample of input tension. True where it leaves a turning point and so many wait by
  /// now that settle() is worth its call: once for each such push() is enough, later is no harm as
  /// long as the queue has room. Constant time; may interrupt every other member of the same
  /// estimator but the ones that say otherwise.
  bool push(std::size_t tendon, Tension input_tension) {
    Channel& channel = channels_[tendon];
    return channel.state.push(input_tension, channel.parameters) >= kEnough;
  }
  /// Takes one sample of motor current; without a drive in the parameters it counts as missing.
  bool push(std::size_t tendon, MotorCurrent current) {
    if (!channels_[tendon].parameters.has_drive()) {
      push_missing(tendon);
      return false;
    }
    return push(tendon, input_tension(tendon, current));
  }
  /// Takes one sample of output tension, with the direction of the tendon and the bend angle.
  bool push(std::size_t tendon, Tension output_tension, Direction direction, Angle bend) {
    return push(tendon, input_tension(tendon, output_tension, direction, bend));
  }
  /// What push() would count of such samples, for a caller that needs it besides.
  /// @pre the parameters have a drive
  [[nodiscard]] Tension input_tension(std::size_t tendon, MotorCurrent current) {
    return channels_[tendon].parameters.drive.tension(current,
                                                      channels_[tendon].state.input_flags());
  }
  [[nodiscard]] Tension input_tension(std::size_t tendon, Tension output_tension,
                                      Direction direction, Angle bend) {
    return channels_[tendon].parameters.capstan.input_tension(
        output_tension, bend, direction, channels_[tendon].state.input_flags());
  }
  /// Samples are missing: the sensor dropped out, or the loop was late. Each call counts as one
  /// gap.
  void push_missing(std::size_t tendon, std::uint32_t samples = 1) {
    channels_[tendon].state.push_missing(samples);
  }
  /// Flags of the tendon, for a caller that converts its samples itself.
  Flags& input_flags(std::size_t tendon) { return channels_[tendon].state.input_flags(); }

  /// Counts what push() has left of one tendon, the one of which most waits, in bounded time.
  /// False, and nothing done, where of none so much waits that it is worth the call: a few turning
  /// points. A reading takes in the rest.
  bool settle() { return settle(NoObservers{}); }

  /// The same; `observers(tendon)` hears of each cycle, see NoObserver.
  template <class Observers>
  bool settle(Observers&& observers) {
    std::size_t fullest = 0;
    std::uint32_t most = channels_[0].state.waiting();
    for (std::size_t tendon = 1; tendon < kTendons; ++tendon) {
      const std::uint32_t waiting = channels_[tendon].state.waiting();
      fullest = waiting > most ? tendon : fullest;
      most = waiting > most ? waiting : most;
    }
    if (most < kEnough) {
      return false;
    }
    Channel& channel = channels_[fullest];
    channel.state.template settle<kCycles>(channel.parameters, observers(fullest));
    return true;
  }

  /// Counts all that push() has left of a tendon; `observer` hears of each cycle.
  template <class Observer = NoObserver>
  void flush(std::size_t tendon, Observer observer = {}) {
    Channel& channel = channels_[tendon];
    channel.state.template flush<kCycles>(channel.parameters, observer);
  }

  /// Takes many samples of one tendon at once: the same as push() and settle() for each, and faster
  /// where there is a large queue. push() must not interrupt it.
  template <class Observer = NoObserver>
  void replay(std::size_t tendon, std::span<const Tension> samples, Observer observer = {}) {
    flush(tendon, observer);
    channels_[tendon].state.replay(samples, channels_[tendon].parameters, observer);
  }

  /// The same of a stretch of samples of which the full cycles have been taken out, see
  /// bulk/replay.hpp. False, and nothing taken in, where the samples have to be replayed.
  bool replay(std::size_t tendon, const Stretch& stretch) {
    flush(tendon);
    return channels_[tendon].state.replay(stretch, channels_[tendon].parameters);
  }

  /// Life used at this instant. Flushes first; `observer` hears of the cycles that this counts for
  /// good, `open` of those that are in the reading beside them: the next reading has them again.
  /// Bounded by the capacity of the queue and of the residue.
  template <class Observer, class Open>
  [[nodiscard]] Reading reading(std::size_t tendon, Observer observer, Open open) {
    Reading result;
    do {
      flush(tendon, observer);
    } while (!channels_[tendon].state.read(channels_[tendon].parameters, result, open));
    return result;
  }
  /// The same, with one who hears of all of them.
  template <class Observer = NoObserver>
  [[nodiscard]] Reading reading(std::size_t tendon, Observer observer = {}) {
    return reading(tendon, observer, observer);
  }

  /// Forgets the flags that counting has raised; those of the samples are in input_flags().
  void forget_flags(std::size_t tendon) { channels_[tendon].state.forget_flags(); }

  [[nodiscard]] const Model& parameters(std::size_t tendon) const {
    return channels_[tendon].parameters;
  }

  /// The largest snapshot.
  static constexpr std::size_t kSnapshotBytes =
      kSnapshotHeaderBytes + kTendons * (4 + Tendon<Layout>::kStoredBytes) + 4;

  /// Writes the whole state into `out` of at least kSnapshotBytes; gives the part that was used.
  /// push() must not interrupt it.
  std::span<const std::byte> snapshot(std::span<std::byte> out) const {
    ByteWriter body(out.subspan(kSnapshotHeaderBytes));
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      body.u32(channels_[tendon].parameters.model_digest);
      channels_[tendon].state.store(body);
    }
    const std::size_t size = kSnapshotHeaderBytes + body.size();
    ByteWriter header(out);
    header.u32(kSnapshotMagic);
    header.u32(kSnapshotVersion);
    header.u32(static_cast<std::uint32_t>(size + 4));
    header.u32(static_cast<std::uint32_t>(kTendons));
    ByteWriter(out.subspan(size)).u32(crc32(out.first(size)));
    return out.first(size + 4);
  }

  /// Takes up the state of a snapshot, so that counting continues as if it had never stopped.
  /// Refuses what it cannot trust and then keeps the state it had. push() must not interrupt it.
  SnapshotError restore(std::span<const std::byte> bytes,
                        ModelChange change = ModelChange::refuse) {
    const SnapshotError framed = check_snapshot(bytes, static_cast<std::uint32_t>(kTendons));
    if (framed != SnapshotError::none) {
      return framed;
    }
    const auto body = bytes.subspan(kSnapshotHeaderBytes, bytes.size() - kSnapshotHeaderBytes - 4);
    for (const bool replace : {false, true}) {
      ByteReader in(body);
      for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
        if (in.u32() != channels_[tendon].parameters.model_digest &&
            change == ModelChange::refuse) {
          return SnapshotError::other_model;
        }
        if (!channels_[tendon].state.load(in, replace)) {
          return SnapshotError::implausible;
        }
      }
      if (in.remaining() != 0) {
        return SnapshotError::implausible;
      }
    }
    return SnapshotError::none;
  }

 private:
  /// Cycles that one settle() counts at most.
  static constexpr std::uint32_t kCycles = 4;
  /// Turning points of a tendon that make settle() worth its call.
  static constexpr std::uint32_t kEnough = 6;
  static_assert(2 * kEnough <= Layout::kQueue, "the queue has room while settle() waits");

  struct NoObservers {
    constexpr NoObserver operator()(std::size_t) const { return {}; }
  };

  struct Channel {
    Model parameters{};
    Tendon<Layout> state;
  };

  std::array<Channel, kTendons> channels_;
};

}  // namespace lifemodel
