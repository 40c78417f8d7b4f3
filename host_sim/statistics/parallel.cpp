#include "host_sim/statistics/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace host_sim::statistics {
namespace {

std::size_t threads_for(std::size_t count, unsigned wanted) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  return std::max<std::size_t>(1, std::min<std::size_t>(count, wanted == 0 ? cores : wanted));
}

class Team {
 public:
  Team(std::size_t count, const std::function<void(std::size_t)>& work)
      : count_(count), work_(work) {}

  void take_part() {
    for (std::size_t i = next_++; i < count_; i = next_++) {
      try {
        work_(i);
      } catch (...) {
        stop_with(std::current_exception());
      }
    }
  }

  void rethrow() const {
    if (error_) {
      std::rethrow_exception(error_);
    }
  }

 private:
  void stop_with(std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    next_ = count_;
    if (!error_) {
      error_ = std::move(error);
    }
  }

  std::size_t count_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr error_;
};

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work,
                  unsigned threads) {
  Team team(count, work);
  {
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < threads_for(count, threads); ++i) {
      helpers.emplace_back([&team] { team.take_part(); });
    }
    team.take_part();
  }
  team.rethrow();
}

}  // namespace host_sim::statistics
