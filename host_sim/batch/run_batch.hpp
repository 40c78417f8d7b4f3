#pragma once

#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "host_sim/batch/ranks.hpp"

namespace host_sim::batch {

/// What came of one piece of a batch. All texts are UTF-8.
struct Answer {
  std::string row;                 ///< its line of the table
  std::string json;                ///< one object on one line
  std::string error;               ///< one line; empty where there is none
  std::vector<std::string> found;  ///< what `--fail-on` may ask for
};

/// What the work on a piece gets from the batch.
struct Means {
  unsigned threads;                            ///< that it may use
  std::function<void(double share)> progress;  ///< of the piece, 0 .. 1; throws Interruption
};

/// One kind of work on many pieces, by all threads of all ranks. A piece is a text of any bytes.
struct Batch {
  std::string label;     ///< of the progress bar
  unsigned threads = 0;  ///< of each rank; 0 is its share of the cores
  /// Finds the pieces, one at least, and opens the outputs; on rank 0 alone.
  std::function<std::vector<std::string>()> list;
  std::function<Answer(const std::string& piece, const Means& means)> work;
  /// The answer for a piece whose work threw `error`: it does not stop the others.
  std::function<Answer(const std::string& piece, const std::exception& error)> refuse;
  /// Writes the answers, in order of the pieces, and gives the exit status; on rank 0 alone.
  std::function<int(const std::vector<Answer>& answers)> report;
};

/// @param ranks made before the outputs: these are removed before a rank that fails ends all others
/// @return the exit status; 0 on other ranks than rank 0
/// @throws Interruption, what `list` and `report` throw, and std::runtime_error where memory ran
/// out
int run_batch(Ranks& ranks, const Batch& batch);

/// An error of the work on `place` as one line.
std::string error_line(const std::exception& error, const std::string& place);

}  // namespace host_sim::batch
