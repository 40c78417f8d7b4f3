#pragma once

#include <fcntl.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "firmware/storage/store.hpp"
#include "firmware/storage/succession.hpp"
#include "hal/error.hpp"
#include "hal/linux/file_calls.hpp"
#include "hal/linux/file_error.hpp"
#include "hal/linux/file_generations.hpp"
#include "hal/linux/file_log.hpp"

namespace hal::linux_os {

/// The life of `kTendons` tendons in a folder; a storage::Store. See FileGenerations and FileLog
/// for what a power cut leaves.
///
/// The folder holds `life`, `life.previous`, `authority.log`, and `lock`, by which one controller
/// keeps others out for as long as it runs.
template <std::size_t kTendons, FileCalls Calls = PosixFileCalls>
class FileStore {
  using Generations = FileGenerations<kTendons, Calls>;

 public:
  /// Refuses a folder that is missing, cannot be written or is in use, and files that cannot be
  /// read or are of another configuration. Damaged files are worked around; see notices().
  static std::variant<FileStore, FileError> open(const std::string& folder, Calls calls = {}) {
    FileHandle<Calls> lock(calls, folder + "/lock", O_RDWR | O_CREAT | O_NOFOLLOW);
    if (lock.error() != 0) {
      return refused(folder, lock.error());
    }
    if (calls.lock(lock.get()) != 0) {
      return refused(folder, errno);
    }
    FileHandle<Calls> directory(calls, folder, O_RDONLY | O_DIRECTORY);
    if (directory.error() != 0) {
      return refused(folder, directory.error());
    }
    Generations generations(calls, folder);
    auto loaded = generations.load();
    if (auto* error = std::get_if<FileError>(&loaded)) {
      return std::move(*error);
    }
    auto& [image, notices] = std::get<typename Generations::Loaded>(loaded);
    auto log = FileLog<Calls>::open(calls, folder + "/authority.log", notices);
    if (auto* error = std::get_if<FileError>(&log)) {
      return std::move(*error);
    }
    auto& log_file = std::get<FileLog<Calls>>(log);
    if (!image.lost.front() && image.sequence == 0 && log_file.saved_once()) {
      image.lost.fill(true);
      notices.push_back({folder + "/life",
                         "missing, though the log tells of saves; accepted: the file that belongs "
                         "to the log, or an empty folder"});
    }
    if (calls.fsync(directory.get()) != 0) {
      return refused(folder, errno);
    }
    return FileStore(calls, std::move(lock), std::move(directory), std::move(generations),
                     std::move(log_file), image, std::move(notices));
  }

  /// What was found damaged, a line each.
  [[nodiscard]] const std::vector<FileError>& notices() const { return notices_; }
  /// Why the last save failed, of records or parameters; nothing if it did not.
  [[nodiscard]] const std::optional<FileError>& problem() const { return problem_; }

  [[nodiscard]] std::optional<storage::LifeRecord> load(std::size_t tendon) const {
    return tendon < kTendons ? image_.lives[tendon] : std::nullopt;
  }
  [[nodiscard]] bool past_lost() const {
    for (const bool lost : image_.lost) {
      if (lost) {
        return true;
      }
    }
    return false;
  }
  [[nodiscard]] std::uint32_t sequence() const { return image_.sequence; }

  hal::Error save(std::span<const storage::LifeRecord> records) {
    if (!storage::may_follow<kTendons>(records, image_.lives)) {
      return hal::Error::out_of_range;
    }
    if (attempted_ == std::numeric_limits<std::uint32_t>::max()) {
      return hal::Error::full;
    }
    ++attempted_;
    auto next = image_;
    next.sequence = attempted_;
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      const auto record = storage::successor(records[tendon], image_.lives[tendon],
                                             image_.lost[tendon], attempted_);
      next.lives[tendon] = record;
      next.lost[tendon] = record.past_lost;
    }
    return commit(next);
  }

  [[nodiscard]] std::optional<lifemodel::ParameterBlock> load_parameters(std::size_t tendon) const {
    return tendon < kTendons ? image_.parameters[tendon] : std::nullopt;
  }
  hal::Error save_parameters(std::size_t tendon, const lifemodel::ParameterBlock& block) {
    if (tendon >= kTendons) {
      return hal::Error::out_of_range;
    }
    auto next = image_;
    next.parameters[tendon] = block;
    return commit(next);
  }

  hal::Error append(const storage::LogEntry& entry) { return log_.append(entry); }
  [[nodiscard]] std::optional<storage::LogEntry> log(std::uint32_t i) const {
    return log_.entry(i);
  }

 private:
  FileStore(Calls calls, FileHandle<Calls> lock, FileHandle<Calls> directory,
            Generations generations, FileLog<Calls> log, const FileImage<kTendons>& image,
            std::vector<FileError> notices)
      : calls_(calls),
        lock_(std::move(lock)),
        directory_(std::move(directory)),
        generations_(std::move(generations)),
        log_(std::move(log)),
        image_(image),
        notices_(std::move(notices)),
        attempted_(image.sequence) {}

  static FileError refused(const std::string& folder, Errno error) {
    constexpr const char* kAccepted =
        "; accepted: an existing folder that this controller may write, used by no other";
    if (error == ENOENT) {
      return {folder, std::string("there is no such folder") + kAccepted};
    }
    if (error == EWOULDBLOCK) {
      return {folder, std::string("in use by another controller") + kAccepted};
    }
    return {folder, std::string("cannot be used: ") + std::strerror(error) + kAccepted};
  }

  hal::Error commit(const FileImage<kTendons>& next) {
    problem_ = generations_.store(next, directory_.get());
    if (problem_) {
      return hal::Error::failed;
    }
    image_ = next;
    return hal::Error::none;
  }

  Calls calls_;
  FileHandle<Calls> lock_;
  FileHandle<Calls> directory_;
  Generations generations_;
  FileLog<Calls> log_;
  FileImage<kTendons> image_;
  std::vector<FileError> notices_;
  std::optional<FileError> problem_;
  std::uint32_t attempted_;  ///< the highest sequence that may have been written
};

}  // namespace hal::linux_os
