#include "host_sim/statistics/random.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

namespace host_sim::statistics {
namespace {

/// std::seed_seq of six words for an engine of 624 (C++20, 26.6.8.1 paragraph 7), the same numbers
/// without a division for each index.
class SeedSequence {
 public:
  using result_type = std::uint32_t;

  explicit SeedSequence(const std::array<std::uint32_t, 6>& words) : words_(words) {}

  /// @pre room for kSize words
  void generate(std::uint32_t* begin, [[maybe_unused]] const std::uint32_t* end) const {
    assert(end - begin == static_cast<std::ptrdiff_t>(kSize));
    std::fill_n(begin, kSize, 0x8b8b8b8bU);
    constexpr std::size_t kWide = 11;
    constexpr std::size_t kNear = (kSize - kWide) / 2;
    constexpr std::size_t kFar = kNear + kWide;
    std::uint32_t before = begin[kSize - 1];
    for (std::size_t k = 0; k < kSize; ++k) {
      std::uint32_t& near = begin[wrapped(k + kNear)];
      const std::uint32_t mixed = 1664525U * folded(begin[k] ^ near ^ before);
      before = mixed + added(k);
      near += mixed;
      begin[wrapped(k + kFar)] += before;
      begin[k] = before;
    }
    for (std::size_t k = 0; k < kSize; ++k) {
      std::uint32_t& near = begin[wrapped(k + kNear)];
      const std::uint32_t mixed = 1566083941U * folded(begin[k] + near + before);
      before = mixed - static_cast<std::uint32_t>(k);
      near ^= mixed;
      begin[wrapped(k + kFar)] ^= before;
      begin[k] = before;
    }
  }

 private:
  static constexpr std::size_t kSize = 624;

  static std::size_t wrapped(std::size_t index) { return index < kSize ? index : index - kSize; }
  static std::uint32_t folded(std::uint32_t value) { return value ^ (value >> 27U); }

  [[nodiscard]] std::uint32_t added(std::size_t k) const {
    if (k == 0) {
      return static_cast<std::uint32_t>(words_.size());
    }
    return static_cast<std::uint32_t>(k) + (k <= words_.size() ? words_[k - 1] : 0);
  }

  std::array<std::uint32_t, 6> words_;
};

std::mt19937_64 engine_for(std::uint64_t seed, std::uint64_t stream, std::uint64_t number) {
  std::array<std::uint32_t, 6> words{};
  std::size_t next = 0;
  for (const std::uint64_t value : {seed, stream, number}) {
    words[next++] = static_cast<std::uint32_t>(value);
    words[next++] = static_cast<std::uint32_t>(value >> 32U);
  }
  SeedSequence sequence(words);
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
