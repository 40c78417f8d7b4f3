// Writes the example profile: the paper's upper-arm application (section 4.1), synthetic.
//
// Integers throughout, so that every machine writes the same bytes.

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <string>

#include "hal/files/output_file.hpp"

namespace {

constexpr int kSamplesPerTurn = 600;  // 200 Hz, crank at 20 rpm
constexpr int kTurns = 20;
constexpr int kTimeStepMs = 5;

constexpr std::int64_t kTensionMean100uN = 385'000;        // (28.5 + 48.5) / 2 N
constexpr std::int64_t kTensionAmplitude100uN = 100'000;   // (48.5 - 28.5) / 2 N
constexpr std::int64_t kNoise100uN = 200;                  // standard deviation
constexpr std::int64_t kVelocityAmplitudeUmPerS = 52'360;  // 25 mm * 2 pi / 3 s

constexpr int kFractionBits = 30;
constexpr std::int64_t kOne = std::int64_t{1} << kFractionBits;

std::int64_t rounded_product(std::int64_t value, std::int64_t fraction) {
  return (value * fraction + kOne / 2) >> kFractionBits;
}

/// The angle of the crank, as cosine and sine in units of 1 / kOne.
struct Crank {
  std::int64_t cosine = kOne;
  std::int64_t sine = 0;

  void turn_by_one_sample() {
    constexpr std::int64_t kStepCosine = 1'073'682'950;  // cos(2 pi / 600) * 2^30
    constexpr std::int64_t kStepSine = 11'243'993;       // sin(2 pi / 600) * 2^30
    const std::int64_t before = cosine;
    cosine = rounded_product(before, kStepCosine) - rounded_product(sine, kStepSine);
    sine = rounded_product(sine, kStepCosine) + rounded_product(before, kStepSine);
  }
};

/// Nearly normal noise: twelve uniform numbers of 16 bits have the standard deviation 2^16.
class Noise {
 public:
  std::int64_t next(std::int64_t standard_deviation) {
    constexpr int kNumbers = 12;
    std::int64_t sum = -std::int64_t{kNumbers / 2} * 65'536;
    for (int i = 0; i < kNumbers; ++i) {
      state_ = state_ * 6'364'136'223'846'793'005U + 1'442'695'040'888'963'407U;
      sum += static_cast<std::int64_t>(state_ >> 48);
    }
    return sum * standard_deviation / 65'536;
  }

 private:
  std::uint64_t state_ = 1;
};

std::string profile() {
  std::string text =
      "# Synthetic, not a recording: the output tension of the paper's upper-arm application,\n"
      "# 28.5 to 48.5 N over a bend of 270 deg, crank of 25 mm at 20 rpm, 20 turns of 3 s at 200 "
      "Hz.\n"
      "# The tension rises while the tendon is pulled and falls while it is released.\n"
      "# Sensor noise of 0.02 N (standard deviation) is added to the tension.\n"
      "time_s,output_tension_N,tendon_velocity_m_s,bend_angle_deg\n";
  Crank crank;
  Noise noise;
  for (int sample = 0; sample <= kTurns * kSamplesPerTurn; ++sample) {
    if (sample % kSamplesPerTurn == 0) {
      crank = Crank{};
    }
    const int time_ms = sample * kTimeStepMs;
    const std::int64_t tension_100uN = kTensionMean100uN -
                                       rounded_product(kTensionAmplitude100uN, crank.cosine) +
                                       noise.next(kNoise100uN);
    const std::int64_t velocity_um_s = rounded_product(kVelocityAmplitudeUmPerS, crank.sine);
    fmt::format_to(std::back_inserter(text), "{}.{:03},{}.{:04},{}0.{:06},270.0\n", time_ms / 1000,
                   time_ms % 1000, tension_100uN / 10'000, tension_100uN % 10'000,
                   velocity_um_s < 0 ? "-" : "", std::abs(velocity_um_s));
    crank.turn_by_one_sample();
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: {} FILE.csv\n", argv[0]);
    return 2;
  }
  try {
    hal::files::write_file(argv[1], profile());
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
