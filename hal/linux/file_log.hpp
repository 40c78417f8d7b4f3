#pragma once

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "firmware/storage/entry_codec.hpp"
#include "firmware/storage/store.hpp"
#include "hal/error.hpp"
#include "hal/linux/file_calls.hpp"
#include "hal/linux/file_error.hpp"
#include "hal/linux/file_io.hpp"

namespace hal::linux_os {

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
    const auto read = read_up_to(calls, log.file_.get(), kCapacity * storage::kEntryBytes + 1);
    if (const Errno* error = std::get_if<Errno>(&read)) {
      return FileError{path, std::string("cannot read it: ") + std::strerror(*error)};
    }
    log.take(std::get<std::vector<std::byte>>(read), path, notices);
    return log;
  }

  hal::Error append(storage::LogEntry entry) {
    if (static_cast<std::size_t>(end_) / storage::kEntryBytes >= kCapacity) {
      return hal::Error::full;
    }
    entry.number = entries_.empty() ? 0 : entries_.back().number + 1;
    const auto bytes = storage::encode(entry);
    if (write_all(calls_, file_.get(), bytes, end_) != 0 || calls_.fsync(file_.get()) != 0) {
      return hal::Error::failed;
    }
    end_ += static_cast<off_t>(bytes.size());
    entries_.push_back(entry);
    return hal::Error::none;
  }

  [[nodiscard]] std::optional<storage::LogEntry> entry(std::uint32_t i) const {
    return i < entries_.size() ? std::optional(entries_[i]) : std::nullopt;
  }
  /// Whether an entry was made after a save.
  [[nodiscard]] bool saved_once() const {
    return std::ranges::any_of(entries_, [](const auto& entry) { return entry.sequence != 0; });
  }

 private:
  void take(std::span<const std::byte> bytes, const std::string& path,
            std::vector<FileError>& notices) {
    constexpr std::size_t kEntry = storage::kEntryBytes;
    const bool grown = bytes.size() > kCapacity * kEntry;
    std::size_t places = bytes.size() / kEntry;
    std::vector<std::size_t> damaged;
    for (std::size_t place = 0; place < places; ++place) {
      const auto entry =
          storage::decode_entry(bytes.subspan(place * kEntry).template first<kEntry>());
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
  std::vector<storage::LogEntry> entries_;
  off_t end_ = 0;  ///< of the last whole entry
};

}  // namespace hal::linux_os
