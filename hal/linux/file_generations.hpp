#pragma once

#include <fcntl.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "hal/linux/file_calls.hpp"
#include "hal/linux/file_error.hpp"
#include "hal/linux/file_image.hpp"
#include "hal/linux/file_io.hpp"
#include "lifemodel/support/saturating.hpp"

namespace hal::linux_os {

/// The newest image of a folder and the one before: the files `life` and `life.previous`.
///
/// A new image is written beside them, synced and then renamed, and the folder is synced: whenever
/// the power goes, one of the two files is a whole image and at least as new as the last one that
/// was committed. A damaged file is kept as `life.damaged` and never takes the place of a good one.
template <std::size_t kTendons, FileCalls Calls>
class FileGenerations {
 public:
  using Image = FileImage<kTendons>;

  struct Loaded {
    Image image;
    std::vector<FileError> notices;  ///< what was damaged
  };

  FileGenerations(Calls calls, std::string folder)
      : calls_(calls), life_(std::move(folder) + "/life") {}

  /// The newest image that is whole, a blank one where there is no file.
  std::variant<Loaded, FileError> load() {
    Loaded result;
    auto newest = load_file(life_);
    if (auto* error = std::get_if<FileError>(&newest)) {
      return std::move(*error);
    }
    File& life = std::get<File>(newest);
    if (life.image) {
      result.image = *life.image;
      return result;
    }
    damaged_ = life.damage.has_value();
    auto older = load_file(previous());
    if (auto* error = std::get_if<FileError>(&older)) {
      return std::move(*error);
    }
    File& before = std::get<File>(older);
    note(result, life, before);
    if (before.image) {
      result.image = *before.image;
      // The damaged file was one save ahead.
      result.image.sequence = lifemodel::saturating_add(result.image.sequence, damaged_ ? 1u : 0u);
    } else if (damaged_ || before.damage) {
      result.image.lost.fill(true);
    }
    return result;
  }

  /// Makes `image` the newest. Nothing where it is committed; else the files are as they were, or
  /// the next load() finds either.
  std::optional<FileError> store(const Image& image, int folder_fd) {
    const std::string partial = life_ + ".partial";
    if (const Errno error = write_partial(partial, image); error != 0) {
      return failure(partial, "write", error);
    }
    const std::string aside = damaged_ ? life_ + ".damaged" : previous();
    if (calls_.rename(life_.c_str(), aside.c_str()) != 0 && errno != ENOENT) {
      return failure(life_, "rename", errno);
    }
    damaged_ = false;
    if (calls_.rename(partial.c_str(), life_.c_str()) != 0) {
      return failure(partial, "rename", errno);
    }
    if (calls_.fsync(folder_fd) != 0) {
      return failure(life_, "sync the folder of", errno);
    }
    return {};
  }

 private:
  /// Neither where there is no file.
  struct File {
    std::optional<Image> image;
    std::optional<std::string> damage;
  };

  [[nodiscard]] std::string previous() const { return life_ + ".previous"; }

  static FileError failure(const std::string& path, const char* what, Errno error) {
    return {path, std::string("cannot ") + what + " it: " + std::strerror(error)};
  }

  std::variant<File, FileError> load_file(const std::string& path) {
    const FileHandle<Calls> file(calls_, path, O_RDONLY);
    if (file.error() == ENOENT) {
      return File{};
    }
    if (file.error() != 0) {
      return failure(path, "open", file.error());
    }
    const auto read = read_up_to(calls_, file.get(), file_image::kMostBytes + 1);
    if (const Errno* error = std::get_if<Errno>(&read)) {
      return failure(path, "read", *error);
    }
    const auto decoded = decode_image<kTendons>(std::get<std::vector<std::byte>>(read));
    if (const auto* image = std::get_if<Image>(&decoded)) {
      return File{*image, {}};
    }
    const auto& fault = std::get<ImageFault>(decoded);
    if (fault.foreign) {
      return FileError{path, fault.what};
    }
    return File{{}, fault.what};
  }

  void note(Loaded& result, const File& life, const File& before) const {
    if (life.damage) {
      result.notices.push_back(
          {life_, *life.damage + (before.image ? "; the save before is used"
                                               : "; there is no save before to use")});
    }
    if (before.damage) {
      result.notices.push_back({previous(), *before.damage});
    }
  }

  Errno write_partial(const std::string& path, const Image& image) {
    FileHandle<Calls> file(calls_, path, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW);
    if (file.error() != 0) {
      return file.error();
    }
    const auto bytes = encode(image);
    if (const Errno error = write_all(calls_, file.get(), bytes, 0); error != 0) {
      return error;
    }
    if (calls_.fsync(file.get()) != 0) {
      return errno;
    }
    return file.close();
  }

  Calls calls_;
  std::string life_;
  bool damaged_ = false;
};

}  // namespace hal::linux_os
