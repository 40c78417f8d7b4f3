#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace hal::linux_os {

/// How late a periodic task woke up, in classes of 1 us; the last class is open above. One thread
/// notes, any may read: each number is right for itself.
class Jitter {
 public:
  static constexpr std::size_t kClasses = 1'024;

  /// Precondition: late_ns >= 0.
  void note(std::int64_t late_ns, std::uint32_t missed) {
    const auto late_us = static_cast<std::uint64_t>(late_ns) / 1'000;
    add(classes_[late_us < kClasses ? static_cast<std::size_t>(late_us) : kClasses - 1], 1);
    add(missed_, missed);
    if (late_us > worst_us_.load(std::memory_order_relaxed)) {
      worst_us_.store(late_us, std::memory_order_relaxed);
    }
  }

  [[nodiscard]] std::uint64_t worst_us() const { return worst_us_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t missed() const { return missed_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t count(std::size_t late_us) const {
    return classes_[late_us].load(std::memory_order_relaxed);
  }

  /// The lateness that `per_mille` of all wake-ups did not exceed, rounded up to 1 us; the worst
  /// where that lies in the open class, 0 without wake-ups. Precondition: per_mille <= 1000.
  [[nodiscard]] std::uint64_t quantile_us(std::uint32_t per_mille) const {
    std::uint64_t all = 0;
    for (const auto& one : classes_) {
      all += one.load(std::memory_order_relaxed);
    }
    const std::uint64_t wanted =
        (all / 1'000) * per_mille + (all % 1'000 * per_mille + 999) / 1'000;
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i + 1 < kClasses && all != 0; ++i) {
      seen += classes_[i].load(std::memory_order_relaxed);
      if (seen >= wanted) {
        return i + 1 < worst_us() ? i + 1 : worst_us();
      }
    }
    return worst_us();
  }

 private:
  static void add(std::atomic<std::uint64_t>& sum, std::uint64_t n) {
    sum.store(sum.load(std::memory_order_relaxed) + n, std::memory_order_relaxed);
  }

  std::array<std::atomic<std::uint64_t>, kClasses> classes_{};
  std::atomic<std::uint64_t> missed_{0};
  std::atomic<std::uint64_t> worst_us_{0};
};

}  // namespace hal::linux_os
