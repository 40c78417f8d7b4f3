#pragma once

#include <mutex>
#include <optional>
#include <string_view>
#include <vector>

#include "host_sim/io/progress.hpp"

namespace host_sim::batch {

/// One progress bar for pieces of work that several threads do.
class SharedProgress {
 public:
  /// @param pieces of all ranks
  /// @param own of this rank, one at least, which are the whole of its bar
  /// @param shown whether there is a bar
  SharedProgress(std::string_view label, std::size_t pieces, std::size_t own, bool shown);

  /// Says that `share`, 0 .. 1, of a piece is done. For any thread.
  void set(std::size_t piece, double share);

 private:
  std::mutex mutex_;
  std::vector<double> shares_;
  double own_;
  double done_ = 0;
  std::optional<Progress> bar_;
};

}  // namespace host_sim::batch
