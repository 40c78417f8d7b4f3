#include "host_sim/batch/shared_progress.hpp"

namespace host_sim::batch {

SharedProgress::SharedProgress(std::string_view label, std::size_t pieces, std::size_t own,
                               bool shown)
    : shares_(pieces), own_(static_cast<double>(own)) {
  if (shown) {
    bar_.emplace(label);
  }
}

void SharedProgress::set(std::size_t piece, double share) {
  const std::lock_guard lock(mutex_);
  done_ += share - shares_[piece];
  shares_[piece] = share;
  if (bar_) {
    bar_->update_share(done_ / own_);
  }
}

}  // namespace host_sim::batch
