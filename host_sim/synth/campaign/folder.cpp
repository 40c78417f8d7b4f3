#include "host_sim/synth/campaign/folder.hpp"

#include <fcntl.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "hal/files/input_error.hpp"
#include "hal/files/output_file.hpp"
#include "host_sim/campaign/campaign.hpp"

namespace host_sim::synth {

using hal::files::OutputError;
using hal::files::partial_of;
using hal::files::reason_of;
using hal::files::sync_folder_of;

namespace {

namespace fs = std::filesystem;

/// `/a/b/` as `/a/b`, so that a name can be put behind it.
fs::path without_end_slash(fs::path path) {
  path = path.lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

/// In one step: swaps with what stands there, or takes an empty place.
bool rename_or_swap(const fs::path& from, const fs::path& to, bool swap) {
  return ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(),
                     swap ? RENAME_EXCHANGE : RENAME_NOREPLACE) == 0;
}

}  // namespace

StagedFolder::StagedFolder(fs::path path, bool replace)
    : path_(without_end_slash(std::move(path))), replace_(replace) {
  check_place();
  partial_ = partial_of(path_);
  std::error_code error;
  fs::remove_all(partial_, error);
  if (!fs::create_directory(partial_, error) || error) {
    throw OutputError(path_.string(), error ? error.message() : "its place is taken");
  }
}

StagedFolder::~StagedFolder() {
  if (!committed_) {
    std::error_code ignored;
    fs::remove_all(partial_, ignored);
  }
}

void StagedFolder::check_place() const {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(path_, error);
  if (status.type() == fs::file_type::not_found) {
    return;
  }
  if (!replace_) {
    throw OutputError(path_.string(), "it exists; --force replaces a campaign");
  }
  if (status.type() != fs::file_type::directory || !is_campaign(path_)) {
    throw OutputError(path_.string(), "what stands there is no campaign, and is not replaced");
  }
}

void StagedFolder::commit() {
  check_place();
  const bool swap = fs::exists(path_);
  if (!rename_or_swap(partial_, path_, swap)) {
    throw OutputError(path_.string(), reason_of(errno));
  }
  committed_ = true;
  sync_folder_of(path_);
  if (swap) {
    std::error_code ignored;
    fs::remove_all(partial_, ignored);
  }
}

}  // namespace host_sim::synth
