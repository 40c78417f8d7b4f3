#pragma once

#include <cstddef>
#include <vector>

namespace host_sim::recording {

/// Samples in a row.
struct Stretch {
  std::size_t first = 0;
  std::size_t count = 0;

  [[nodiscard]] std::size_t end() const { return first + count; }
  friend bool operator==(const Stretch&, const Stretch&) = default;
};

/// The stretches of samples whose mark is `wanted`, in order, leaving out those under `least`.
std::vector<Stretch> stretches_of(const std::vector<bool>& marks, bool wanted,
                                  std::size_t least = 1);

}  // namespace host_sim::recording
