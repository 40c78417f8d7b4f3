#include "host_sim/recording/stretch.hpp"

namespace host_sim::recording {

std::vector<Stretch> stretches_of(const std::vector<bool>& marks, bool wanted, std::size_t least) {
  std::vector<Stretch> stretches;
  std::size_t first = 0;
  while (first < marks.size()) {
    std::size_t end = first;
    while (end < marks.size() && marks[end] == wanted) {
      ++end;
    }
    if (end > first && end - first >= least) {
      stretches.push_back({first, end - first});
    }
    first = end + (end == first ? 1 : 0);
  }
  return stretches;
}

}  // namespace host_sim::recording
