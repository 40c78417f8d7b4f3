#pragma once

#include <filesystem>

namespace host_sim::synth {

/// A folder that appears whole or not at all: it is filled under the name `path.partial-<pid>`
/// beside its place, and removed without commit().
class StagedFolder {
 public:
  /// @param replace whether a campaign that stands there may be replaced; anything else that stands
  ///   there is never touched
  /// @throws OutputError
  StagedFolder(std::filesystem::path path, bool replace);
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;
  ~StagedFolder();

  /// Where to write.
  [[nodiscard]] const std::filesystem::path& inside() const { return partial_; }

  /// Puts the folder in its place. @throws OutputError
  void commit();

 private:
  void check_place() const;

  std::filesystem::path path_;
  std::filesystem::path partial_;
  bool replace_;
  bool committed_ = false;
};

}  // namespace host_sim::synth
