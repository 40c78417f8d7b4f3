// Instructions that the estimator takes: on average for each sample, and for the worst single call.
// Argument 1 is the JSON file to write.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/boards/qemu_mps2/measurement.hpp"
#include "firmware/boards/qemu_mps2/semihosting.hpp"
#include "firmware/boards/qemu_mps2/text.hpp"
#include "tests/target/entry/entry.hpp"
#include "tests/target/model/paper_model.hpp"
#include "tests/target/signals.hpp"

namespace board = boards::qemu_mps2;

namespace target {
namespace {

constexpr std::size_t kSamples = 20'000;
constexpr std::size_t kChunk = 1'000;
/// Tendon t of four sees the signal by t times this many samples ahead.
constexpr std::size_t kShift = 251;

std::array<std::int32_t, kSamples + 3 * kShift> samples;

// The loops of which the average is taken, and the same without the estimator.

[[gnu::noinline]] void loop_one(One* estimator, const std::int32_t* from, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (push_one(estimator, from[i])) {
      settle_one(estimator);
    }
  }
}

[[gnu::noinline]] void loop_four(Four* estimator, const std::int32_t* from, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t tendon = 0; tendon < 4; ++tendon) {
      if (push_four(estimator, tendon, from[i + tendon * kShift])) {
        settle_four(estimator);
      }
    }
  }
}

/// All that waits at once, as a loop without a bound of its own does.
[[gnu::noinline]] void settle_all(One* estimator) {
  while (settle_one(estimator)) {
  }
}

template <std::size_t kTendons>
[[gnu::noinline]] void empty_loop(void*, const std::int32_t* from, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      __asm__ volatile("" : : "r"(from[i + tendon * kShift]));
    }
  }
}

struct Worst {
  std::uint32_t push = 0;
  std::uint32_t settle = 0;
  std::uint32_t settle_all = 0;
  std::uint32_t reading = 0;
};

class Measurement {
 public:
  void averages() {
    struct Average {
      const char* name;
      void (*fill)(std::span<std::int32_t>);
    };
    constexpr std::array kAverages{Average{"idle", constant}, Average{"sine", sine},
                                   Average{"noise", noisy_sine}, Average{"white", white_noise}};
    board::write("instructions a sample, push and settle:\n");
    for (const Average& a : kAverages) {
      a.fill(samples);
      report(a.name, "_one", average<1>(loop_one));
      report(a.name, "_four", average<4>(loop_four));
    }
  }

  void worst_calls() {
    Worst one;
    Worst four;
    for (const Signal& signal : kSignals) {
      signal.fill(samples);
      constexpr std::size_t kCount = 4000;
      find_worst(one, kCount, 1, 1);
      find_worst(one, kCount, 7, 1);
      find_worst(one, kCount, 32, 40);
      find_worst(one, kCount, 200, 80);
      find_worst_of_all(one, kCount);
      find_worst_of_four(four, kCount);
    }
    board::write("instructions of the worst single call:\n");
    report("push", "_one", one.push * 1000);
    report("push", "_four", four.push * 1000);
    report("settle", "_one", one.settle * 1000);
    report("settle", "_four", four.settle * 1000);
    report("settle_all", "_one", one.settle_all * 1000);
    report("reading", "_one", one.reading * 1000);
  }

  /// Hours to 10, 50 and 90 % and the probability of a break, of wires of all ages and shapes.
  void given_survival_calls() {
    Random random(3);
    std::uint32_t worst = 0;
    for (int i = 0; i < 4000; ++i) {
      const auto shape = lifemodel::WeibullShape::from_raw(
          (1u << 24) + static_cast<std::uint32_t>(random.below(99 << 24)));
      Wear wear{drawn(random), drawn(random)};
      if (i % 2 == 0) {
        wear.used = lifemodel::LifePoint{random.next()}.damage();
        wear.each = lifemodel::LifePoint{random.next() >> 20}.damage();
      }
      GivenSurvival result{};
      worst = std::max(worst, counter_.count({given_survival, &shape, &wear, &result}));
    }
    report("given_survival", "", worst * 1000);
  }

  /// The load that is advised to wires of all ages, with loads of all sizes.
  void advised_calls() {
    Random random(4);
    const lifemodel::Parameters parameters = paper_parameters<1>()[0];
    std::uint32_t worst = 0;
    for (int i = 0; i < 4000; ++i) {
      const Wear wear{lifemodel::LifePoint{random.next() >> 2}.damage(),
                      lifemodel::LifePoint{(random.next() >> (8 + i % 20)) + 1}.damage()};
      Advised result{lifemodel::Tension::from_raw(static_cast<std::int32_t>(random.next() >> 3)),
                     {}};
      worst = std::max(worst, counter_.count({advised, &parameters, &wear, &result}));
    }
    report("advised", "", worst * 1000);
  }

  [[nodiscard]] bool save(const char* path) {
    json_ << "\n}\n";
    board::HostFile file(path, board::HostFile::Mode::write);
    const std::span text(json_.c_str(), json_.size());
    return file.is_open() && file.write(std::as_bytes(text));
  }

 private:
  /// Of any magnitude.
  static lifemodel::Damage drawn(Random& random) {
    lifemodel::Damage::Words words{};
    const auto top = static_cast<std::size_t>(random.below(4));
    for (std::size_t i = 0; i <= top; ++i) {
      words[i] = random.next();
    }
    return lifemodel::Damage::from_words(words);
  }

  void report(const char* name, const char* suffix, std::uint32_t thousandths) {
    board::Text<100> line;
    line << "  " << name << suffix << " " << thousandths / 1000 << ".";
    line.decimal(thousandths % 1000, 3) << "\n";
    board::write(line.c_str());
    json_ << (json_.size() == 0 ? "{\n" : ",\n") << "  \"" << name << suffix
          << "\": " << thousandths / 1000 << ".";
    json_.decimal(thousandths % 1000, 3);
  }

  /// Average for a sample of one tendon, in thousandths.
  template <std::size_t kTendons, class Estimator>
  std::uint32_t average(void (*loop)(Estimator*, const std::int32_t*, std::size_t)) const {
    Estimator estimator(paper_parameters<kTendons>());
    std::uint32_t total = 0;
    for (std::size_t i = 0; i < kSamples; i += kChunk) {
      total += counter_.count({loop, &estimator, &samples[i], kChunk});
      total -= counter_.count({empty_loop<kTendons>, nullptr, &samples[i], kChunk});
    }
    constexpr std::uint32_t kCounted = kSamples * kTendons;
    return (total / kCounted) * 1000 + (total % kCounted) * 1000 / kCounted;
  }

  /// Every call on its own: settles after each `settle_every` samples, `settle_calls` times.
  void find_worst(Worst& worst, std::size_t count, std::size_t settle_every,
                  std::uint32_t settle_calls) const {
    One estimator(paper_parameters<1>());
    lifemodel::Reading reading{};
    for (std::size_t i = 0; i < count; ++i) {
      worst.push = std::max(worst.push, counter_.count({push_one, &estimator, samples[i]}));
      if (i % settle_every == settle_every - 1) {
        for (std::uint32_t call = 0; call < settle_calls; ++call) {
          worst.settle = std::max(worst.settle, counter_.count({settle_one, &estimator}));
        }
      }
      if (i % 97 == 96) {
        One copy = estimator;
        worst.reading = std::max(worst.reading, counter_.count({reading_one, &copy, &reading}));
      }
    }
  }

  void find_worst_of_all(Worst& worst, std::size_t count) const {
    One estimator(paper_parameters<1>());
    for (std::size_t i = 0; i < count; ++i) {
      if (push_one(&estimator, samples[i])) {
        worst.settle_all = std::max(worst.settle_all, counter_.count({settle_all, &estimator}));
      }
    }
  }

  void find_worst_of_four(Worst& worst, std::size_t count) const {
    Four estimator(paper_parameters<4>());
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t tendon = 0; tendon < 4; ++tendon) {
        worst.push =
            std::max(worst.push,
                     counter_.count({push_four, &estimator, tendon, samples[i + tendon * kShift]}));
      }
      worst.settle = std::max(worst.settle, counter_.count({settle_four, &estimator}));
    }
  }

  board::InstructionCounter counter_;
  board::Text<4096> json_;
};

}  // namespace
}  // namespace target

int main() {
  const boards::qemu_mps2::Arguments arguments;
  if (arguments.count() != 2) {
    return 2;
  }
  target::Measurement measurement;
  measurement.averages();
  measurement.worst_calls();
  measurement.given_survival_calls();
  measurement.advised_calls();
  return measurement.save(arguments[1]) ? 0 : 1;
}
