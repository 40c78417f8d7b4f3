#pragma once

#include <filesystem>

namespace host_sim::diagnose {

/// A new folder for files of this run, gone with all of them at the end.
class ScratchFolder {
 public:
  /// @throws OutputError
  ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace host_sim::diagnose
