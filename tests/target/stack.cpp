// Stack that the estimator's calls were seen to use. Argument 1 is the JSON file to write.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
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

constexpr std::size_t kSamples = 700;

std::array<std::int32_t, kSamples> samples;

struct Deepest {
  std::uint32_t push = 0;
  std::uint32_t settle = 0;
  std::uint32_t reading = 0;
  std::uint32_t memcpy = 0;
  std::uint32_t memset = 0;
};

void measure_estimator(Deepest& deepest, std::size_t settle_every) {
  One estimator(paper_parameters<1>());
  lifemodel::Reading reading{};
  for (std::size_t i = 0; i < kSamples; ++i) {
    deepest.push = std::max(deepest.push, board::stack_bytes({push_one, &estimator, samples[i]}));
    if (i % settle_every == settle_every - 1) {
      deepest.settle = std::max(deepest.settle, board::stack_bytes({settle_one, &estimator}));
    }
    if (i % 61 == 60) {
      One copy = estimator;
      deepest.reading =
          std::max(deepest.reading, board::stack_bytes({reading_one, &copy, &reading}));
    }
  }
}

void measure_library(Deepest& deepest) {
  static std::array<char, 600> from;
  static std::array<char, 600> to;
  for (std::size_t size = 0; size < 300; size = size < 70 ? size + 1 : size + 67) {
    for (std::size_t shift = 0; shift < 4; ++shift) {
      deepest.memcpy = std::max(
          deepest.memcpy, board::stack_bytes({std::memcpy, to.data() + shift, from.data(), size}));
      deepest.memset =
          std::max(deepest.memset, board::stack_bytes({std::memset, to.data() + shift, 1, size}));
    }
  }
}

int run(const char* path) {
  Deepest deepest;
  for (const Signal& signal : kSignals) {
    signal.fill(samples);
    measure_estimator(deepest, 1);
    measure_estimator(deepest, 50);
  }
  measure_library(deepest);

  board::Text<400> json;
  json << "{\n  \"push_one\": " << deepest.push << ",\n  \"settle_one\": " << deepest.settle
       << ",\n  \"reading_one\": " << deepest.reading << ",\n  \"memcpy\": " << deepest.memcpy
       << ",\n  \"memset\": " << deepest.memset << "\n}\n";
  board::HostFile file(path, board::HostFile::Mode::write);
  const std::span text(json.c_str(), json.size());
  return file.is_open() && file.write(std::as_bytes(text)) ? 0 : 1;
}

}  // namespace
}  // namespace target

int main() {
  const boards::qemu_mps2::Arguments arguments;
  return arguments.count() == 2 ? target::run(arguments[1]) : 2;
}
