#pragma once

#include <string>
#include <vector>

namespace host_sim::batch {

/// The processes that share a batch: those that mpirun started, or this one alone where the program
/// was built without MPI. One object in each process, made before any work.
///
/// All ranks make the same calls in the same order. Waiting takes no processor time and ends with
/// Interruption when the user stops the program. A rank whose object is destroyed by an exception
/// before leave() ends all ranks, for they would wait for it in vain. Outputs belong into objects
/// made later: what ends ranks gives them no time to remove files.
class Ranks {
 public:
  Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  ~Ranks();  // NOLINT(performance-trivially-destructible): ends them where there are others

  [[nodiscard]] std::size_t rank() const { return rank_; }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// How many of them run on this machine, this one included.
  [[nodiscard]] std::size_t on_this_machine() const { return on_this_machine_; }

  /// The text that rank 0 gives, on every rank. Up to 2 GB.
  std::string broadcast(std::string text);

  /// The texts of all ranks in their order on rank 0; nothing on the others. Up to 2 GB together.
  std::vector<std::string> gather(const std::string& text);

  /// The ranks need each other no more; they part when their objects are destroyed.
  void leave() { left_ = true; }
  [[nodiscard]] bool has_left() const { return left_; }

 private:
  std::size_t rank_ = 0;
  std::size_t count_ = 1;
  std::size_t on_this_machine_ = 1;
  bool left_ = false;
};

}  // namespace host_sim::batch
