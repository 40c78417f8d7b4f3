#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>

#include "host_sim/monitor/fleet/watch.hpp"
#include "host_sim/monitor/record/log_folder.hpp"

namespace host_sim::monitor {

/// Records every frame to the logs of a folder. A thread of its own writes and syncs, each second
/// and at each new log, so that a slow disk delays no frame. What came after the last sync is lost
/// with the power; what came within the last kWrite with the process. What cannot be written waits
/// and is tried again.
class Recorder final : public Observer {
 public:
  static constexpr std::chrono::milliseconds kWrite{100};
  static constexpr std::chrono::milliseconds kSync{1000};
  /// What waits for a disk at most; more is lost and counted.
  static constexpr std::size_t kMostWaiting = std::size_t{64} << 20;

  /// `interface`: the name in the logs, 1 .. 15 printable characters without spaces.
  /// @throws OutputError
  Recorder(const std::filesystem::path& folder, const Rotation& rotation, std::string interface);
  /// Writes and syncs what waits.
  ~Recorder() override;

  void see(const SeenFrame& seen) override;
  /// All that was seen can be read in the folder, or trouble() says why not.
  void flush();
  /// All that was seen is on the disk, or trouble() says why not.
  void sync();
  void finish() override { sync(); }

  /// What was found torn at the start, for people; empty where nothing was.
  [[nodiscard]] const std::string& repaired() const { return folder_.repaired(); }
  /// Why frames are not recorded at present, and how many are not; empty where all is well.
  [[nodiscard]] std::string trouble() const override;

 private:
  void run();
  void write(std::unique_lock<std::mutex>& lock);
  void write_taken(std::unique_lock<std::mutex>& lock);
  void sync_folder(std::unique_lock<std::mutex>& lock);

  LogFolder folder_;
  std::string interface_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::condition_variable done_;
  std::string waiting_;
  std::string writing_;  ///< what the thread has taken of it and not written; its alone
  std::string trouble_;
  std::string sync_trouble_;  ///< stays: what was written before may be lost
  std::uint64_t waiting_frames_ = 0;
  std::uint64_t writing_bytes_ = 0;
  std::uint64_t writing_frames_ = 0;
  std::uint64_t lost_frames_ = 0;  ///< for which there was no room to wait
  std::uint64_t flushes_asked_ = 0;
  std::uint64_t flushes_done_ = 0;
  std::uint64_t syncs_asked_ = 0;
  std::uint64_t syncs_done_ = 0;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace host_sim::monitor
