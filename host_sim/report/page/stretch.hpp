#pragma once

#include <cstddef>
#include <vector>

/// What of a recording is drawn: some of its cycles, and nothing where nothing was recorded.
namespace host_sim {

/// Samples from `first` up to but not including `last`.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Two cycles of the input tension from the middle of a recording, from where it rises through its
/// mean; one where there are no two, and all of it where there is none.
[[nodiscard]] Stretch cycles_in(const std::vector<double>& input_N);

/// The values of these samples. @pre they are there
[[nodiscard]] std::vector<double> part_of(const std::vector<double>& values,
                                          const Stretch& stretch);

/// Samples after a time that nothing was recorded in, as indices.
[[nodiscard]] std::vector<std::size_t> gaps_in(const std::vector<double>& time_s);

/// Values of a line that is not drawn where nothing was recorded: a value that is none stands
/// before each of these samples.
[[nodiscard]] std::vector<double> with_gaps(const std::vector<double>& values,
                                            const std::vector<std::size_t>& gaps);

}  // namespace host_sim
