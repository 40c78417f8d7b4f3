#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/files/input_error.hpp"
#include "hal/files/input_file.hpp"
#include "hal/files/profile.hpp"

namespace host_sim::test {

/// What `act` complains about; an empty text if it does not.
template <typename Act>
std::string complaint_of(Act act) {
  try {
    act();
  } catch (const hal::files::InputError& error) {
    return error.what();
  }
  return {};
}

/// All rows of a profile in memory, read `chunk` at a time.
inline std::vector<hal::files::ProfileRow> rows_of(std::unique_ptr<hal::files::ByteSource> source,
                                                   hal::files::ProfileOptions options = {},
                                                   std::size_t chunk = 64) {
  hal::files::ProfileReader reader(std::move(source), "p.csv", options);
  std::vector<hal::files::ProfileRow> rows;
  std::vector<hal::files::ProfileRow> part(chunk);
  while (const std::size_t count = reader.read(part)) {
    rows.insert(rows.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return rows;
}

inline std::vector<hal::files::ProfileRow> rows_of(std::string_view text,
                                                   hal::files::ProfileOptions options = {}) {
  return rows_of(hal::files::memory_source(text), options);
}

inline std::string profile_complaint(std::string_view text,
                                     hal::files::ProfileOptions options = {}) {
  return complaint_of([&] { rows_of(text, options); });
}

inline bool same(const hal::files::ProfileRow& a, const hal::files::ProfileRow& b) {
  return a.time_s == b.time_s && a.value == b.value &&
         a.tendon_velocity_m_s == b.tendon_velocity_m_s && a.bend_angle_deg == b.bend_angle_deg;
}

inline bool same(const std::vector<hal::files::ProfileRow>& a,
                 const std::vector<hal::files::ProfileRow>& b) {
  if (a.size() != b.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same(a[i], b[i])) {
      return false;
    }
  }
  return true;
}

/// While it lives the process has the rights of nobody, even if it was started by root.
class WithoutPrivileges {
 public:
  WithoutPrivileges() : before_(::geteuid()) {
    if (before_ == 0 && ::seteuid(kNobody) != 0) {
      throw std::runtime_error("root cannot give up its rights");
    }
  }
  WithoutPrivileges(const WithoutPrivileges&) = delete;
  WithoutPrivileges& operator=(const WithoutPrivileges&) = delete;
  ~WithoutPrivileges() { EXPECT_EQ(::seteuid(before_), 0); }

 private:
  static constexpr uid_t kNobody = 65534;
  uid_t before_;
};

/// A folder of its own, removed at the end, that everybody may use.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "tendonlife-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw std::runtime_error("no temporary folder");
    }
    path_ = name;
    std::filesystem::permissions(path_, std::filesystem::perms::all);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }

  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }

  std::size_t file_count() const {
    const std::filesystem::directory_iterator files(path_);
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
  }

 private:
  std::filesystem::path path_;
};

inline void write_text(const std::filesystem::path& path, std::string_view text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace host_sim::test
