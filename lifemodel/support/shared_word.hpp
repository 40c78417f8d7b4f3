#pragma once

#include <atomic>
#include <cstdint>
#include <type_traits>

namespace lifemodel {

/// A microcontroller has one core, which sees its own memory in order even across an interrupt:
/// only the compiler has to be held back. Define LIFEMODEL_SEVERAL_CORES where another core pushes.
#if defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M' && !defined(LIFEMODEL_SEVERAL_CORES)
inline constexpr bool kSeveralCores = false;
#else
inline constexpr bool kSeveralCores = true;
#endif

inline void fence(std::memory_order order) {
  if constexpr (kSeveralCores) {
    std::atomic_thread_fence(order);
  } else {
    std::atomic_signal_fence(order);
  }
}

/// A word that one side writes and the other reads, where the two may be an interrupt and what it
/// interrupts, or two cores. Copies as a plain value.
template <class T>
class SharedWord {
  static_assert(std::atomic_ref<T>::is_always_lock_free);

 public:
  constexpr SharedWord() = default;
  constexpr explicit SharedWord(T value) : value_(value) {}

  [[nodiscard]] T relaxed() const { return ref().load(std::memory_order_relaxed); }
  void set_relaxed(T value) { ref().store(value, std::memory_order_relaxed); }
  /// The same for a word that nothing waits for: with one core a plain store.
  constexpr void set_plain(T value) {
    if (!kSeveralCores || std::is_constant_evaluated()) {
      value_ = value;
    } else {
      set_relaxed(value);
    }
  }

  [[nodiscard]] T acquire() const {
    if constexpr (kSeveralCores) {
      return ref().load(std::memory_order_acquire);
    }
    const T value = relaxed();
    fence(std::memory_order_acquire);
    return value;
  }
  void release(T value) {
    if constexpr (kSeveralCores) {
      ref().store(value, std::memory_order_release);
    } else {
      fence(std::memory_order_release);
      set_relaxed(value);
    }
  }

  /// For the side that writes it.
  [[nodiscard]] constexpr T own() const { return value_; }

 private:
  // atomic_ref takes no const object before C++26.
  [[nodiscard]] std::atomic_ref<T> ref() const {
    return std::atomic_ref<T>(const_cast<T&>(value_));
  }

  T value_{};
};

/// Lets a reader on another core notice that several words changed while it read them. The writer
/// never waits. With one core it costs nothing: a writer that interrupts has finished when the
/// reader continues.
class TurnLock {
 public:
  /// Writer: before and after a change of several words.
  void begin() {
    if constexpr (kSeveralCores) {
      turns_.set_relaxed(turns_.own() + 1);
      fence(std::memory_order_release);
    }
  }
  void end() {
    if constexpr (kSeveralCores) {
      turns_.release(turns_.own() + 1);
    }
  }

  /// Reader: what to compare with after reading; odd while a change is under way.
  [[nodiscard]] std::uint32_t start() const { return kSeveralCores ? turns_.acquire() : 0; }
  /// Reader: whether what was read since start() belongs together.
  [[nodiscard]] bool unchanged(std::uint32_t started) const {
    fence(std::memory_order_acquire);
    return !kSeveralCores || (started % 2 == 0 && turns_.relaxed() == started);
  }

 private:
  SharedWord<std::uint32_t> turns_;
};

}  // namespace lifemodel
