#pragma once

#include <atomic>

namespace lifemodel {

/// A word that one side writes and the other reads, where the two may be an interrupt and what it
/// interrupts, or two cores. Copies as a plain value.
template <class T>
class SharedWord {
  static_assert(std::atomic_ref<T>::is_always_lock_free);

 public:
  constexpr SharedWord() = default;
  constexpr explicit SharedWord(T value) : value_(value) {}

  [[nodiscard]] T relaxed() const { return ref().load(std::memory_order_relaxed); }
  [[nodiscard]] T acquire() const { return ref().load(std::memory_order_acquire); }
  void set_relaxed(T value) { ref().store(value, std::memory_order_relaxed); }
  void release(T value) { ref().store(value, std::memory_order_release); }

  /// For the side that writes it.
  [[nodiscard]] constexpr T own() const { return value_; }

 private:
  // atomic_ref takes no const object before C++26.
  [[nodiscard]] std::atomic_ref<T> ref() const {
    return std::atomic_ref<T>(const_cast<T&>(value_));
  }

  T value_{};
};

}  // namespace lifemodel
