#include "host_sim/monitor/record/recorder.hpp"

#include <fmt/format.h>

#include <utility>

#include "host_sim/io/output_file.hpp"
#include "host_sim/monitor/record/log_line.hpp"

namespace host_sim::monitor {

Recorder::Recorder(const std::filesystem::path& folder, const Rotation& rotation,
                   std::string interface)
    : folder_(folder, rotation), interface_(std::move(interface)), thread_([this] { run(); }) {}

Recorder::~Recorder() {
  {
    const std::scoped_lock lock(mutex_);
    ending_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Recorder::see(const SeenFrame& seen) {
  const std::string line = log_line(seen, interface_);
  const std::scoped_lock lock(mutex_);
  if (waiting_.size() + line.size() > kMostWaiting) {
    ++lost_frames_;
    return;
  }
  waiting_ += line;
  ++waiting_frames_;
}

void Recorder::flush() {
  std::unique_lock lock(mutex_);
  const std::uint64_t ours = ++flushes_asked_;
  wake_.notify_one();
  done_.wait(lock, [&] { return flushes_done_ >= ours; });
}

void Recorder::sync() {
  std::unique_lock lock(mutex_);
  const std::uint64_t ours = ++syncs_asked_;
  wake_.notify_one();
  done_.wait(lock, [&] { return syncs_done_ >= ours; });
}

std::string Recorder::trouble() const {
  const std::scoped_lock lock(mutex_);
  if (lost_frames_ == 0) {
    return trouble_;
  }
  return fmt::format("{}{}{} frames were not recorded", trouble_, trouble_.empty() ? "" : "; ",
                     lost_frames_);
}

void Recorder::run() {
  using Clock = std::chrono::steady_clock;
  Clock::time_point next_sync = Clock::now() + kSync;
  std::unique_lock lock(mutex_);
  for (bool last = false; !last;) {
    wake_.wait_for(lock, kWrite, [this] {
      return ending_ || flushes_asked_ != flushes_done_ || syncs_asked_ != syncs_done_;
    });
    last = ending_;
    const std::uint64_t flushes_asked = flushes_asked_;
    const std::uint64_t syncs_asked = syncs_asked_;
    write(lock);
    flushes_done_ = flushes_asked;
    done_.notify_all();
    if (last || syncs_asked != syncs_done_ || Clock::now() >= next_sync) {
      lock.unlock();
      std::string trouble;
      try {
        folder_.sync();
      } catch (const OutputError& error) {
        trouble = error.what();
      }
      lock.lock();
      if (trouble_.empty()) {
        trouble_ = std::move(trouble);
      }
      syncs_done_ = syncs_asked;
      done_.notify_all();
      next_sync = Clock::now() + kSync;
    }
  }
}

void Recorder::write(std::unique_lock<std::mutex>& lock) {
  if (waiting_.empty()) {
    return;
  }
  const std::string lines = std::exchange(waiting_, {});
  const std::uint64_t frames = std::exchange(waiting_frames_, 0);
  lock.unlock();
  std::string trouble;
  try {
    folder_.add(lines);
  } catch (const std::exception& error) {
    trouble = error.what();
  }
  lock.lock();
  lost_frames_ += trouble.empty() ? 0 : frames;
  trouble_ = std::move(trouble);
}

}  // namespace host_sim::monitor
