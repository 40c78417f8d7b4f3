#include "host_sim/monitor/record/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "hal/files/output_file.hpp"
#include "host_sim/monitor/bus/frame_log.hpp"

namespace host_sim::monitor {

using hal::files::OutputError;

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
  if (waiting_.size() + writing_bytes_ + line.size() > kMostWaiting) {
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
  std::string report = trouble_.empty() ? sync_trouble_ : trouble_;
  const std::uint64_t missing =
      lost_frames_ + (trouble_.empty() ? 0 : waiting_frames_ + writing_frames_);
  if (missing != 0) {
    report += fmt::format("{}{} frames were not recorded", report.empty() ? "" : "; ", missing);
  }
  return report;
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
      sync_folder(lock);
      syncs_done_ = syncs_asked;
      done_.notify_all();
      next_sync = Clock::now() + kSync;
    }
  }
}

void Recorder::write(std::unique_lock<std::mutex>& lock) {
  const bool again = !writing_.empty();
  write_taken(lock);
  if (again && trouble_.empty()) {
    write_taken(lock);
  }
}

void Recorder::write_taken(std::unique_lock<std::mutex>& lock) {
  if (writing_.empty()) {
    writing_.swap(waiting_);
    writing_frames_ = std::exchange(waiting_frames_, 0);
    writing_bytes_ = writing_.size();
  }
  lock.unlock();
  std::string trouble;
  std::string_view left = writing_;
  try {
    folder_.add(left);
  } catch (const std::exception& error) {
    trouble = error.what();
  }
  writing_.erase(0, writing_.size() - left.size());
  const auto frames = std::count(writing_.begin(), writing_.end(), '\n');
  lock.lock();
  writing_bytes_ = writing_.size();
  writing_frames_ = static_cast<std::uint64_t>(frames);
  trouble_ = std::move(trouble);
}

void Recorder::sync_folder(std::unique_lock<std::mutex>& lock) {
  lock.unlock();
  std::string trouble;
  try {
    folder_.sync();
  } catch (const OutputError& error) {
    trouble = error.what();
  }
  lock.lock();
  if (sync_trouble_.empty()) {
    sync_trouble_ = std::move(trouble);
  }
}

}  // namespace host_sim::monitor
