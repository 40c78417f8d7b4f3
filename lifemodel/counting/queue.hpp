#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "lifemodel/quantity/units.hpp"
#include "lifemodel/support/shared_word.hpp"

namespace lifemodel {

/// Turning points on their way from push() to settle(): one producer, which may be an interrupt or
/// another core, and one consumer. Neither waits for the other.
template <std::size_t kCapacity>
class TurningPointQueue {
  static_assert(kCapacity >= 8 && (kCapacity & (kCapacity - 1)) == 0, "a power of two");

 public:
  /// Producer: places that are free.
  [[nodiscard]] std::uint32_t free() const {
    return static_cast<std::uint32_t>(kCapacity) - (head_.own() - tail_.acquire());
  }
  /// Producer: appends. Precondition: free() > 0.
  void put(Tension turning_point) {
    points_[head_.own() % kCapacity] = turning_point;
    head_.release(head_.own() + 1);
  }

  /// Producer: appends many without a branch for each.
  class Batch {
   public:
    explicit Batch(TurningPointQueue& queue) : queue_(queue), head_(queue.head_.own()) {}
    Batch(const Batch&) = delete;
    Batch& operator=(const Batch&) = delete;
    ~Batch() { queue_.head_.release(head_); }
    /// Appends where `wanted`. Precondition: a place is free, wanted or not.
    void put_if(bool wanted, Tension turning_point) {
      queue_.points_[head_ % kCapacity] = turning_point;
      head_ += wanted ? 1 : 0;
    }

   private:
    TurningPointQueue& queue_;
    std::uint32_t head_;
  };

  /// Consumer: turning points that wait.
  [[nodiscard]] std::uint32_t size() const { return head_.acquire() - tail_.own(); }
  [[nodiscard]] bool empty() const { return size() == 0; }
  /// Consumer. Precondition: index < size().
  [[nodiscard]] Tension at(std::uint32_t index) const {
    return points_[(tail_.own() + index) % kCapacity];
  }
  /// Consumer. Precondition: count <= size().
  void drop(std::uint32_t count) { tail_.release(tail_.own() + count); }

  /// Consumer: what waits as indices first .. last - 1, modulo 2^32.
  struct Range {
    const Tension* points;
    std::uint32_t first;
    std::uint32_t last;
    Tension operator()(std::uint32_t index) const { return points[index % kCapacity]; }
  };
  [[nodiscard]] Range range() const { return {points_.data(), tail_.own(), head_.acquire()}; }

 private:
  SharedWord<std::uint32_t> head_;
  SharedWord<std::uint32_t> tail_;
  std::array<Tension, kCapacity> points_{};
};

}  // namespace lifemodel
