// Whatever the bytes of a log of a record: times that rise, lines that are read whole and to the
// end, and a moment of each time, or an InputError.

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/input_error.hpp"
#include "host_sim/monitor/record/moment.hpp"
#include "tests/fuzz/io/require.hpp"

using host_sim::fuzz::require;
using host_sim::monitor::FrameArchive;

namespace {

/// A folder of this process for as long as it lives.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "recordXXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string read_from(const FrameArchive& archive, std::int64_t from_us) {
  std::string lines;
  archive.read_from(from_us, [&](std::string_view piece) {
    require(piece.empty() || piece.back() == '\n');
    lines += piece;
    return true;
  });
  return lines;
}

void require_sound_from(const FrameArchive& archive, std::int64_t time_us,
                        const std::string& whole) {
  require(whole.ends_with(read_from(archive, time_us)));
  if (time_us > host_sim::monitor::kLatestMoment_us) {
    return;
  }
  try {
    const auto moment = host_sim::monitor::moment_of(archive, {}, time_us);
    require(moment.view.now_ns == time_us * 1000 && moment.from_us <= time_us);
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::ofstream(folder.path() / "frames-00000001.log", std::ios::binary) << text;
  const host_sim::monitor::RecordedFolder archive(folder.path(), [] {});

  const std::vector<std::int64_t> times_us = archive.times_us();
  require(times_us.size() <= FrameArchive::kMostTimes);
  require(std::adjacent_find(times_us.begin(), times_us.end(), std::greater_equal<>()) ==
          times_us.end());
  const std::string whole(text.substr(0, text.rfind('\n') + 1));
  require(read_from(archive, 0) == whole);
  for (std::size_t i = 0; i < times_us.size(); i += 1 + times_us.size() / 3) {
    require_sound_from(archive, times_us[i], whole);
  }
  return 0;
}
