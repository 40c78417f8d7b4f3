#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <thread>
#include <vector>

#include "lifemodel/bulk/instructions.hpp"
#include "lifemodel/bulk/reducer.hpp"
#include "lifemodel/counting/stretch.hpp"
#include "lifemodel/estimator.hpp"

namespace lifemodel::bulk {

/// Replay by several threads, with the same bits for any number of them: each reduces stretches of
/// the samples, and the caller joins these in order, through the filter and the residue of the
/// estimator. The threads last as long as a call, which is worth it from some 100,000 samples on.
class ParallelReplay {
 public:
  /// @param threads at least 1, the caller among them
  /// @param stretch samples that a thread reduces at once, 1 .. Reducer::kMostSamples
  explicit ParallelReplay(unsigned threads, const Instructions& by = *instructions().front(),
                          std::size_t stretch = Reducer::kMostSamples)
      : stretch_(stretch), slots_(std::size_t{kAhead} * threads) {
    // All room that is needed, so that threads do not run out of it.
    reducers_.reserve(threads);
    for (unsigned i = 0; i < threads; ++i) {
      reducers_.emplace_back(by);
    }
    for (Slot& slot : slots_) {
      slot.left.reserve(stretch);
    }
  }

  /// @throws std::system_error where a thread cannot be started; nothing is taken in then
  template <std::size_t kTendons, class Layout>
  void take(Estimator<kTendons, Layout>& estimator, std::size_t tendon,
            std::span<const Tension> samples) {
    const auto& parameters = estimator.parameters(tendon);
    Work work;
    work.count = (samples.size() + stretch_ - 1) / stretch_;
    const auto part = [&](std::size_t index) {
      const auto rest = samples.subspan(index * stretch_);
      return rest.first(std::min(rest.size(), stretch_));
    };
    const auto has_next = [&] {
      return work.next != work.count && work.next < work.joined + slots_.size();
    };
    const auto reduce_next = [&](std::unique_lock<std::mutex>& lock, Reducer& reducer) {
      const std::size_t index = work.next++;
      lock.unlock();
      Slot& slot = slots_[index % slots_.size()];
      slot.take(reducer.reduce(part(index), parameters.hysteresis, parameters.law));
      lock.lock();
      slot.ready = true;
      work.changed.notify_all();
    };
    const auto help = [&](const std::stop_token& stop, Reducer& reducer) {
      std::unique_lock lock(work.mutex);
      while (work.changed.wait(lock, stop, has_next)) {
        reduce_next(lock, reducer);
      }
    };

    for (Slot& slot : slots_) {
      slot.ready = false;
    }
    std::vector<std::jthread> helpers;
    const std::size_t worth = std::min(reducers_.size() - 1, work.count / kWorthAThread);
    for (std::size_t i = 0; i < worth; ++i) {
      helpers.emplace_back(help, std::ref(reducers_[i + 1]));
    }
    std::unique_lock lock(work.mutex);
    while (work.joined != work.count) {
      Slot& slot = slots_[work.joined % slots_.size()];
      if (slot.ready) {
        lock.unlock();
        if (!slot.stretch || !estimator.replay(tendon, *slot.stretch)) {
          estimator.replay(tendon, part(work.joined));
        }
        lock.lock();
        slot.ready = false;
        ++work.joined;
        work.changed.notify_all();
      } else if (has_next()) {
        reduce_next(lock, reducers_.front());
      } else {
        work.changed.wait(lock, [&] { return slot.ready; });
      }
    }
  }

 private:
  /// Stretches of a thread that may wait to be joined.
  static constexpr unsigned kAhead = 4;
  /// Stretches that take longer than to start a thread.
  static constexpr std::size_t kWorthAThread = 8;

  struct Work {
    std::mutex mutex;
    std::condition_variable_any changed;
    std::size_t count = 0;   ///< stretches
    std::size_t next = 0;    ///< to be reduced
    std::size_t joined = 0;  ///< so many have been
  };

  /// What became of a stretch, until it is joined.
  struct Slot {
    std::vector<Tension> left;
    std::optional<Stretch> stretch;
    bool ready = false;

    void take(const std::optional<Stretch>& reduced) {
      stretch = reduced;
      if (stretch) {
        left.assign(stretch->left.begin(), stretch->left.end());
        stretch->left = left;
      }
    }
  };

  std::size_t stretch_;
  std::vector<Reducer> reducers_;
  std::vector<Slot> slots_;
};

}  // namespace lifemodel::bulk
