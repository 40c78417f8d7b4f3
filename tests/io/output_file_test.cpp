#include "hal/files/output_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/io/support.hpp"

namespace {

/// What fsync() was called for, and whether `watched` was there then.
std::string watched;
std::vector<std::pair<std::string, bool>> synced;

}  // namespace

// In place of that of the library.
extern "C" int fsync(int descriptor) {
  std::string path(4096, '\0');
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const ssize_t size = ::readlink(link.c_str(), path.data(), path.size());
  path.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  synced.emplace_back(path, std::filesystem::exists(watched));
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

namespace host_sim {

using hal::files::OutputError;
using hal::files::OutputFile;
using hal::files::partial_of;

namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using test::text_of;
using test::WithoutPrivileges;
using test::write_text;

template <typename Act>
std::string write_complaint(Act act) {
  try {
    act();
  } catch (const OutputError& error) {
    return error.what();
  }
  return {};
}

std::string creation_complaint(const fs::path& path) {
  return write_complaint([&] { const OutputFile file(path); });
}

TEST(OutputFile, AppearsWithCommitAlone) {
  const TemporaryFolder folder;
  const fs::path path = folder / "out.json";
  OutputFile file(path);
  file.write("{\"a\": ");
  file.stream() << 1 << "}\n";
  EXPECT_FALSE(fs::exists(path));
  EXPECT_TRUE(fs::exists(folder / fmt::format("out.json.partial-{}", ::getpid())));
  file.commit();
  EXPECT_EQ(text_of(path), "{\"a\": 1}\n");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(OutputFile, IsOnDiskBeforeItsNameAndItsNameAfterwards) {
  const TemporaryFolder folder;
  const fs::path path = folder / "out.json";
  OutputFile file(path);
  file.write("a");
  watched = path.string();
  synced.clear();
  file.commit();
  const std::string real = fs::canonical(path).string();
  ASSERT_EQ(synced.size(), 2U);
  EXPECT_EQ(synced[0], std::pair(partial_of(real).string(), false));
  EXPECT_EQ(synced[1], std::pair(fs::path(real).parent_path().string(), true));
}

TEST(OutputFile, TakesEveryNameThatTheSystemTakes) {
  const TemporaryFolder folder;
  for (const std::size_t bytes : {1U, 200U, 240U, 241U, 254U, 255U}) {
    const fs::path path = folder / std::string(bytes, 'n');
    OutputFile file(path);
    OutputFile other(folder / (std::string(bytes - 1, 'n') + "m"));
    file.write("a");
    file.commit();
    EXPECT_EQ(text_of(path), "a");
    fs::remove(path);
  }
  EXPECT_EQ(folder.file_count(), 0U);
  const std::string name = (folder / std::string(256, 'n')).string();
  EXPECT_EQ(creation_complaint(name),
            name + ": cannot be written: its name has 256 bytes; accepted: 255 at most");
}

TEST(OutputFile, LeavesNothingWithoutCommit) {
  const TemporaryFolder folder;
  try {
    OutputFile file(folder / "out.json");
    file.write(std::string(1'000'000, 'x'));
    throw std::runtime_error("bad input");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(folder.file_count(), 0U);
}

TEST(OutputFile, KeepsTheEarlierFileWithoutCommit) {
  const TemporaryFolder folder;
  write_text(folder / "out.json", "old");
  {
    OutputFile file(folder / "out.json");
    file.write("new");
  }
  EXPECT_EQ(text_of(folder / "out.json"), "old");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(OutputFile, ReplacesTheEarlierFileAndKeepsItsPermissions) {
  const TemporaryFolder folder;
  const fs::path path = folder / "out.json";
  write_text(path, "old and longer");
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  OutputFile file(path);
  file.write("new");
  file.commit();
  EXPECT_EQ(text_of(path), "new");
  EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(OutputFile, WritesThroughASymbolicLink) {
  const TemporaryFolder folder;
  write_text(folder / "target", "old");
  fs::create_symlink("target", folder / "link");
  OutputFile file(folder / "link");
  file.write("new");
  file.commit();
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(text_of(folder / "target"), "new");
}

TEST(OutputFile, HoldsMoreThanItsBuffer) {
  const TemporaryFolder folder;
  std::string text;
  OutputFile file(folder / "out.csv");
  for (int i = 0; i < 50'000; ++i) {
    const std::string line = fmt::format("{},{}\n", i, i * 7);
    text += line;
    file.write(line);
  }
  file.commit();
  EXPECT_EQ(text_of(folder / "out.csv"), text);
}

TEST(OutputFile, MovesWithItsContent) {
  const TemporaryFolder folder;
  OutputFile first(folder / "out.json");
  first.write("a");
  OutputFile second = std::move(first);
  second.write("b");
  second.commit();
  EXPECT_EQ(text_of(folder / "out.json"), "ab");
}

TEST(OutputFile, FindsAtOnceWhatCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string missing = (folder / "none/out.json").string();
  EXPECT_EQ(creation_complaint(missing),
            missing + ": cannot be written: No such file or directory");
  const std::string directory = (folder / "directory").string();
  fs::create_directory(directory);
  EXPECT_EQ(creation_complaint(directory), directory + ": cannot be written: Is a directory");
  EXPECT_EQ(creation_complaint(directory + "/"),
            directory + "/: cannot be written: it names no file");
  EXPECT_EQ(creation_complaint(""), ": cannot be written: it names no file");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(OutputFile, RespectsPermissions) {
  const TemporaryFolder folder;
  const WithoutPrivileges nobody;
  const fs::path path = folder / "out.json";
  write_text(path, "old");
  fs::permissions(path, fs::perms::owner_read);
  EXPECT_EQ(creation_complaint(path), path.string() + ": cannot be written: Permission denied");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(OutputFile, FindsAtOnceAFolderThatCannotBeWritten) {
  const TemporaryFolder folder;
  fs::permissions(folder / "", fs::perms::owner_read | fs::perms::owner_exec);
  const WithoutPrivileges nobody;
  EXPECT_NE(creation_complaint(folder / "out.json").find("Permission denied"), std::string::npos);
}

TEST(OutputFile, RefusesASecondWriterOfTheSameFile) {
  const TemporaryFolder folder;
  const fs::path path = folder / "out.json";
  OutputFile first(path);
  EXPECT_EQ(creation_complaint(path),
            path.string() + ": cannot be written: it is being written already");
  first.write("first");
  first.commit();
  EXPECT_EQ(text_of(path), "first");
}

TEST(OutputFile, TakesOverWhatAKilledProcessLeft) {
  const TemporaryFolder folder;
  write_text(folder / fmt::format("out.json.partial-{}", ::getpid()), "left over, and long");
  OutputFile file(folder / "out.json");
  file.write("new");
  file.commit();
  EXPECT_EQ(text_of(folder / "out.json"), "new");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(OutputFile, ReportsAFullDevice) {
  ASSERT_TRUE(fs::is_character_file("/dev/full"));
  const WithoutPrivileges nobody;  // who cannot replace a device, should this fail
  const std::string full = "/dev/full: cannot be written: No space left on device";
  EXPECT_EQ(write_complaint([] {
              OutputFile file("/dev/full");
              file.write("a");
              file.commit();
            }),
            full);
  EXPECT_EQ(write_complaint([] {
              OutputFile file("/dev/full");
              file.stream() << std::string(1'000'000, 'x');
            }),
            full);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(OutputFile, WritesDevicesDirectly) {
  const WithoutPrivileges nobody;
  OutputFile file("/dev/null");
  file.write("a");
  file.commit();
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(OutputFile, WritesStandardOutput) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  ::fflush(stdout);
  const int standard_output = ::dup(STDOUT_FILENO);
  ASSERT_EQ(::dup2(ends[1], STDOUT_FILENO), STDOUT_FILENO);
  {
    OutputFile file("-");
    file.write("result\n");
    file.commit();
  }
  EXPECT_EQ(::dup2(standard_output, STDOUT_FILENO), STDOUT_FILENO);
  ::close(standard_output);
  ::close(ends[1]);
  std::string got(64, '\0');
  const ssize_t count = ::read(ends[0], got.data(), got.size());
  ::close(ends[0]);
  ASSERT_GE(count, 0);
  EXPECT_EQ(got.substr(0, static_cast<std::size_t>(count)), "result\n");
  EXPECT_FALSE(fs::exists("-"));
}

TEST(OutputError, IsOneLine) {
  EXPECT_STREQ(OutputError("a\nb", "x\x1b").what(), "a\\nb: cannot be written: x\\x1b");
}

}  // namespace
}  // namespace host_sim
