#include "host_sim/statistics/random.hpp"

#include <array>

namespace host_sim::statistics {
namespace {

std::mt19937_64 engine_for(std::uint64_t seed, std::uint64_t stream, std::uint64_t number) {
  std::array<std::uint32_t, 6> words{};
  std::size_t next = 0;
  for (const std::uint64_t value : {seed, stream, number}) {
    words[next++] = static_cast<std::uint32_t>(value);
    words[next++] = static_cast<std::uint32_t>(value >> 32U);
  }
  std::seed_seq sequence(words.begin(), words.end());
  return std::mt19937_64(sequence);
}

}  // namespace

Random::Random(std::uint64_t seed, std::uint64_t stream, std::uint64_t number)
    : engine_(engine_for(seed, stream, number)) {}

double Random::uniform() {
  constexpr double kStep = 0x1p-53;
  return (static_cast<double>(engine_() >> 11U) + 0.5) * kStep;
}

}  // namespace host_sim::statistics
