#pragma once

#include <fcntl.h>

#include <algorithm>
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

#include "firmware/storage/file_generations.hpp"
#include "firmware/storage/file_io.hpp"
#include "firmware/storage/life_record.hpp"
#include "firmware/storage/log_entry.hpp"
#include "firmware/storage/store.hpp"
#include "hal/error.hpp"

namespace storage {

/// The log as a file of entries, each synced. What an append that was cut has left at the end,
/// never more than an entry, is ignored, and the next append overwrites it; a damaged entry before
/// it is passed over and stays. No append leaves a file longer than kCapacity entries: in such a
/// one the next append overwrites all that comes after the last entry that can be read.
template <FileCalls Calls>
class FileLog {
 public:
  static constexpr std::size_t kCapacity = 65'536;

  FileLog() = default;

  static std::variant<FileLog, FileError> open(Calls calls, std::string path,
                                               std::vector<FileError>& notices) {
    FileLog log;
    log.calls_ = calls;
    log.file_ = FileHandle<Calls>(calls, path, O_RDWR | O_CREAT | O_NOFOLLOW);
    if (log.file_.error() != 0) {
      return FileError{path, std::string("cannot open it: ") + std::strerror(log.file_.error())};
    }
    const auto read = read_up_to(calls, log.file_.get(), kCapacity * kEntryBytes + 1);
    if (const Errno* error = std::get_if<Errno>(&read)) {
      return FileError{path, std::string("cannot read it: ") + std::strerror(*error)};
    }
    log.take(std::get<std::vector<std::byte>>(read), path, notices);
    return log;
  }

  hal::Error append(LogEntry entry) {
    if (static_cast<std::size_t>(end_) / kEntryBytes >= kCapacity) {
      return hal::Error::full;
    }
    entry.number = entries_.empty() ? 0 : entries_.back().number + 1;
    const auto bytes = encode(entry);
    if (write_all(calls_, file_.get(), bytes, end_) != 0 || calls_.fsync(file_.get()) != 0) {
      return hal::Error::failed;
    }
    end_ += static_cast<off_t>(bytes.size());
    entries_.push_back(entry);
    return hal::Error::none;
  }

  [[nodiscard]] std::optional<LogEntry> entry(std::uint32_t i) const {
    return i < entries_.size() ? std::optional(entries_[i]) : std::nullopt;
  }
  /// Whether an entry was made after a save.
  [[nodiscard]] bool saved_once() const {
    return std::ranges::any_of(entries_, [](const auto& entry) { return entry.sequence != 0; });
  }

 private:
  void take(std::span<const std::byte> bytes, const std::string& path,
            std::vector<FileError>& notices) {
    constexpr std::size_t kEntry = kEntryBytes;
    const bool grown = bytes.size() > kCapacity * kEntry;
    std::size_t places = bytes.size() / kEntry;
    std::vector<std::size_t> damaged;
    for (std::size_t place = 0; place < places; ++place) {
      const auto entry = decode_entry(bytes.subspan(place * kEntry).template first<kEntry>());
      if (entry) {
        entries_.push_back(*entry);
      } else {
        damaged.push_back(place);
      }
    }
    // What nobody has written, or one entry that was cut.
    bool cut = !grown && bytes.size() % kEntry != 0;
    while (!damaged.empty() && damaged.back() + 1 == places && (grown || !cut)) {
      damaged.pop_back();
      --places;
      cut = true;
    }
    end_ = static_cast<off_t>(places * kEntry);
    for (std::size_t i = 0; i < damaged.size();) {
      std::size_t run = 1;
      while (i + run < damaged.size() && damaged[i + run] == damaged[i] + run) {
        ++run;
      }
      const std::string first = std::to_string(damaged[i]);
      notices.push_back(
          {path, (run == 1 ? "entry " + first + " is damaged and was"
                           : "entries " + first + " to " + std::to_string(damaged[i + run - 1]) +
                                 " are damaged and were") +
                     " passed over; accepted: entries of " + std::to_string(kEntry) +
                     " bytes whose CRC-32 fits"});
      i += run;
    }
    if (grown) {
      notices.push_back({path, "longer than the " + std::to_string(kCapacity) +
                                   " entries of a log; all from entry " + std::to_string(places) +
                                   " on is ignored"});
    } else if (cut) {
      notices.push_back({path, "its last entry was cut while it was written, and is ignored"});
    }
  }

  Calls calls_{};
  FileHandle<Calls> file_;
  std::vector<LogEntry> entries_;
  off_t end_ = 0;  ///< of the last whole entry
};

/// The life of `kTendons` tendons in a folder; a Store. See FileGenerations and FileLog
/// for what a power cut leaves.
///
/// The folder holds `life`, `life.previous`, `authority.log`, and `lock`, by which one controller
/// keeps others out for as long as it runs.
template <std::size_t kTendons, FileCalls Calls = PosixFileCalls>
class FileStore {
  using Generations = FileGenerations<kTendons, Calls>;

 public:
  /// Bytes that a parameter block may have.
  static constexpr std::size_t kLargestBlock = lifemodel::kMostExtendedBytes;

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
                         "missing, though the log has saves; accepted: the file that belongs "
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

  [[nodiscard]] std::optional<LifeRecord> load(std::size_t tendon) const {
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

  hal::Error save(std::span<const LifeRecord> records) {
    if (!may_follow<kTendons>(records, image_.lives)) {
      return hal::Error::out_of_range;
    }
    if (attempted_ == std::numeric_limits<std::uint32_t>::max()) {
      return hal::Error::full;
    }
    ++attempted_;
    auto next = image_;
    next.sequence = attempted_;
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      const auto record =
          successor(records[tendon], image_.lives[tendon], image_.lost[tendon], attempted_);
      next.lives[tendon] = record;
      next.lost[tendon] = record.past_lost;
    }
    return commit(next);
  }

  [[nodiscard]] std::optional<lifemodel::ExtendedBlock> load_parameters(std::size_t tendon) const {
    return tendon < kTendons ? image_.parameters[tendon] : std::nullopt;
  }
  /// None is ever: a file takes the place of another whole.
  [[nodiscard]] static bool parameters_torn(std::size_t) { return false; }
  hal::Error save_parameters(std::size_t tendon, const lifemodel::ExtendedBlock& block) {
    if (tendon >= kTendons || block.bytes().size() > kLargestBlock) {
      return hal::Error::out_of_range;
    }
    auto next = image_;
    next.parameters[tendon] = block;
    return commit(next);
  }

  hal::Error append(const LogEntry& entry) { return log_.append(entry); }
  [[nodiscard]] std::optional<LogEntry> log(std::uint32_t i) const { return log_.entry(i); }

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

}  // namespace storage
