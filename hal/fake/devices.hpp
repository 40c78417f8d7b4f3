#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hal/devices.hpp"
#include "hal/fake/clock.hpp"
#include "hal/fake/faults.hpp"
#include "hal/fake/random.hpp"

namespace hal::fake {

/// A sensor that gives what it was given: one sample with give(), or a script of them with play(),
/// one at each call. Then there is nothing new.
///
/// A fault takes the place of a sample: the sample is gone, as with a real one.
template <class SampleT, std::size_t kTendons = 1>
class Sensor {
 public:
  using Sample = SampleT;

  explicit Sensor(const Clock& clock) : clock_(clock) {}

  void give(std::size_t tendon, const Sample& sample) { tendons_[tendon].given = sample; }
  /// The script outlives its use. Samples given before go first.
  void play(std::size_t tendon, std::span<const Sample> script) {
    tendons_[tendon].script = script;
  }

  Result<Sample> isr_read(std::size_t tendon) {
    if (tendon >= kTendons) {
      return Error::out_of_range;
    }
    const std::optional<Sample> sample = take(tendons_[tendon]);
    if (const auto fault = faults.next(clock_.now())) {
      return *fault;
    }
    return sample ? Result<Sample>(*sample) : Result<Sample>(Error::missing);
  }

  Faults<Error> faults;

 private:
  struct Tendon {
    std::optional<Sample> given;
    std::span<const Sample> script;
  };

  static std::optional<Sample> take(Tendon& tendon) {
    if (tendon.given) {
      const std::optional<Sample> sample = tendon.given;
      tendon.given.reset();
      return sample;
    }
    if (tendon.script.empty()) {
      return std::nullopt;
    }
    const Sample sample = tendon.script.front();
    tendon.script = tendon.script.subspan(1);
    return sample;
  }

  const Clock& clock_;
  std::array<Tendon, kTendons> tendons_{};
};

static_assert(hal::CurrentSensor<Sensor<lifemodel::MotorCurrent, 2>>);

/// An input line with edges at scripted times.
class DigitalIn {
 public:
  explicit DigitalIn(const Clock& clock) : clock_(clock) {}

  /// From now on. Edges that were scripted are gone.
  void set(bool asserted) {
    level_ = asserted;
    edges_ = 0;
  }
  /// From that time on. Times of one script rise; at most kEdges of them.
  void edge_at(Time time, bool asserted) {
    if (edges_ == kEdges) {
      __builtin_trap();
    }
    all_[edges_++] = {time, asserted};
  }

  Result<bool> asserted() {
    if (const auto fault = faults.next(clock_.now())) {
      return *fault;
    }
    bool level = level_;
    for (std::size_t i = 0; i < edges_ && all_[i].time <= clock_.now(); ++i) {
      level = all_[i].asserted;
    }
    return level;
  }

  static constexpr std::size_t kEdges = 64;
  Faults<Error> faults;

 private:
  struct Edge {
    Time time;
    bool asserted;
  };

  const Clock& clock_;
  bool level_ = false;
  std::array<Edge, kEdges> all_{};
  std::size_t edges_ = 0;
};

/// An output line that remembers. With a fault it stays as it was.
class DigitalOut {
 public:
  explicit DigitalOut(const Clock& clock) : clock_(clock) {}

  Error set(bool asserted) {
    if (const auto fault = faults.next(clock_.now())) {
      return *fault;
    }
    if (asserted != asserted_) {
      asserted_ = asserted;
      changed_at_ = clock_.now();
      ++changes_;
    }
    return Error::none;
  }

  [[nodiscard]] bool asserted() const { return asserted_; }
  [[nodiscard]] Time changed_at() const { return changed_at_; }
  [[nodiscard]] std::uint32_t changes() const { return changes_; }

  Faults<Error> faults;

 private:
  const Clock& clock_;
  bool asserted_ = false;
  Time changed_at_{};
  std::uint32_t changes_ = 0;
};

static_assert(hal::DigitalIn<DigitalIn>);
static_assert(hal::DigitalOut<DigitalOut>);

/// The same bytes for the same seed: for tests, and for runs that have to be repeatable.
class Entropy {
 public:
  Entropy(const Clock& clock, std::uint64_t seed) : clock_(clock), random_(seed) {}

  Error fill(std::span<std::byte> out) {
    const auto fault = faults.next(clock_.now());
    for (std::byte& byte : out) {
      byte = fault ? std::byte{} : static_cast<std::byte>(random_.next() >> 56);
    }
    return fault.value_or(Error::none);
  }

  Faults<Error> faults;

 private:
  const Clock& clock_;
  Random random_;
};

static_assert(hal::Entropy<Entropy>);

/// A watchdog that runs from its construction on and remembers whether it has bitten. It bites
/// where more than its period passes without a feed; feeding it afterwards undoes nothing.
class Watchdog {
 public:
  Watchdog(const Clock& clock, Time period) : clock_(clock), period_(period), fed_(clock.now()) {}

  void feed() {
    bitten_ = bitten();
    fed_ = clock_.now();
    ++feeds_;
  }

  [[nodiscard]] bool bitten() const { return bitten_ || clock_.now() - fed_ > period_; }
  [[nodiscard]] std::uint32_t feeds() const { return feeds_; }

 private:
  const Clock& clock_;
  Time period_;
  Time fed_;
  bool bitten_ = false;
  std::uint32_t feeds_ = 0;
};

static_assert(hal::Watchdog<Watchdog>);

}  // namespace hal::fake
