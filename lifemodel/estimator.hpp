#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "lifemodel/block/parameters.hpp"
#include "lifemodel/state/snapshot.hpp"
#include "lifemodel/tendon.hpp"

namespace lifemodel {

/// The life estimator of one actuator with `kTendons` tendons.
///
/// push() belongs into the control loop or its interrupt, settle() anywhere below it, reading() and
/// snapshots at leisure. Nothing allocates, throws, waits or takes the time; indices are not
/// checked.
///
///   estimator.push(0, tension);        // in the interrupt
///   while (estimator.settle()) {}      // after it, or in the idle loop
///   auto used = estimator.reading(0);  // when somebody asks
template <std::size_t kTendons = 1, class LayoutT = DefaultLayout>
class Estimator {
 public:
  using Layout = LayoutT;
  static constexpr std::size_t tendons() { return kTendons; }

  explicit Estimator(const std::array<Parameters, kTendons>& parameters)
      : parameters_(parameters) {}

  /// Takes one sample of input tension. Constant time; may interrupt every other member of the same
  /// estimator but the ones that say otherwise.
  void push(std::size_t tendon, Tension input_tension) {
    tendons_[tendon].push(input_tension, parameters_[tendon]);
  }
  /// Takes one sample of motor current.
  void push(std::size_t tendon, MotorCurrent current) {
    push(tendon, parameters_[tendon].drive.tension(current, tendons_[tendon].input_flags()));
  }
  /// Takes one sample of output tension, with the direction of the tendon and the bend angle.
  void push(std::size_t tendon, Tension output_tension, Direction direction, Angle bend) {
    push(tendon, parameters_[tendon].capstan.input_tension(output_tension, bend, direction,
                                                           tendons_[tendon].input_flags()));
  }
  /// Samples are missing: the sensor dropped out, or the loop was late.
  void push_missing(std::size_t tendon, std::uint32_t samples = 1) {
    tendons_[tendon].push_missing(samples);
  }
  /// Flags of the tendon, for a caller that converts its samples itself.
  Flags& input_flags(std::size_t tendon) { return tendons_[tendon].input_flags(); }

  /// Counts what push() has left of one tendon, at most Tendon::kSettleSteps steps. True while any
  /// tendon has more.
  bool settle() { return settle(NoObservers{}); }

  /// The same; `observers(tendon)` hears of each cycle, see NoObserver.
  template <class Observers>
  bool settle(Observers&& observers) {
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      if (tendons_[tendon].pending()) {
        tendons_[tendon].template settle<Tendon<Layout>::kSettleSteps>(parameters_[tendon],
                                                                       observers(tendon));
        return tendon + 1 < kTendons || tendons_[tendon].pending();
      }
    }
    return false;
  }

  /// Takes many samples of one tendon at once: the same as push() and settle() for each, and faster
  /// where there is a large queue. push() must not interrupt it.
  template <class Observer = NoObserver>
  void replay(std::size_t tendon, std::span<const Tension> samples, Observer&& observer = {}) {
    tendons_[tendon].replay(samples, parameters_[tendon], observer);
  }

  /// Life used at this instant. Settles first; `observer` hears of the cycles that are still open.
  /// Bounded by the residue's capacity.
  template <class Observer = NoObserver>
  [[nodiscard]] Reading reading(std::size_t tendon, Observer&& observer = {}) {
    return tendons_[tendon].reading(parameters_[tendon], observer);
  }

  [[nodiscard]] const Parameters& parameters(std::size_t tendon) const {
    return parameters_[tendon];
  }
  [[nodiscard]] std::span<const Tension> residue(std::size_t tendon) const {
    return tendons_[tendon].residue();
  }

  /// The largest snapshot.
  static constexpr std::size_t kSnapshotBytes =
      kSnapshotHeaderBytes + kTendons * (4 + Tendon<Layout>::kStoredBytes) + 4;

  /// Writes the whole state into `out` of at least kSnapshotBytes; gives the part that was used.
  /// push() must not interrupt it.
  std::span<const std::byte> snapshot(std::span<std::byte> out) const {
    ByteWriter body(out.subspan(kSnapshotHeaderBytes));
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      body.u32(parameters_[tendon].model_digest);
      tendons_[tendon].store(body);
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

  /// Takes up the state of a snapshot, so that counting goes on as if it had never stopped. Refuses
  /// what it cannot trust and then keeps the state it had. push() must not interrupt it.
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
        if (in.u32() != parameters_[tendon].model_digest && change == ModelChange::refuse) {
          return SnapshotError::other_model;
        }
        if (!tendons_[tendon].load(in, replace)) {
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
  struct NoObservers {
    constexpr NoObserver operator()(std::size_t) const { return {}; }
  };

  std::array<Parameters, kTendons> parameters_;
  std::array<Tendon<Layout>, kTendons> tendons_;
};

}  // namespace lifemodel
