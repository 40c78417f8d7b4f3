#include "host_sim/io/compressed.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "by_the_book.hpp"
#include "support.hpp"

namespace host_sim {
namespace {

using std::string_view_literals::operator""sv;

constexpr std::string_view kText = "time_s,input_tension_N\n0,40\n1,41.5\n";
/// What gzip -n -9 and zstd make of it.
constexpr std::string_view kGzip =
    "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\x03\x2b\xc9\xcc\x4d\x8d\x2f\xd6\xc9\xcc\x2b\x28\x2d\x89"
    "\x2f\x49\xcd\x2b\xce\xcc\xcf\x8b\xf7\xe3\x32\xd0\x31\x31\xe0\x32\xd4\x31\x31\xd4\x33\xe5\x02"
    "\x00\x86\xf3\x05\x46\x23\x00\x00\x00"sv;
constexpr std::string_view kZstd =
    "\x28\xb5\x2f\xfd\x04\x58\x19\x01\x00time_s,input_tension_N\n0,40\n1,41.5\n\x4a\xa7\xdb\x15"sv;

std::string bytes_of(hal::files::ByteSource& source, std::size_t piece) {
  std::string all;
  std::vector<char> buffer(piece);
  while (const std::size_t count = source.read(buffer)) {
    all.append(buffer.data(), count);
  }
  return all;
}

std::string read(std::string_view bytes, std::size_t given, std::size_t asked) {
  const auto source = decompressed(
      std::make_unique<test::PieceSource>(bytes, std::vector<std::size_t>{given}), "p.csv");
  return bytes_of(*source, asked);
}

std::string complaint_of_read(std::string_view bytes) {
  return test::complaint_of([&] { read(bytes, 1 << 20, 1 << 20); });
}

TEST(Compressed, IsReadAsWhatItWas) {
  for (const std::size_t given : {1U, 2U, 7U, 1000U}) {
    for (const std::size_t asked : {1U, 3U, 1000U}) {
      EXPECT_EQ(read(kGzip, given, asked), kText);
      EXPECT_EQ(read(kText, given, asked), kText);
      EXPECT_EQ(read("\x1f is no gzip", given, asked), "\x1f is no gzip");
      EXPECT_EQ(read("(", given, asked), "(");
      EXPECT_EQ(read("", given, asked), "");
    }
  }
}

TEST(Compressed, MembersAreReadOneBehindTheOther) {
  EXPECT_EQ(read(std::string(kGzip) + std::string(kGzip), 5, 4),
            std::string(kText) + std::string(kText));
}

TEST(Compressed, ZstdIsReadWhereTheProgramHasIt) {
  if (complaint_of_read(kZstd) ==
      "p.csv: compressed by zstd, which this program was built without; accepted: what zstd -d "
      "makes of it, or gzip") {
    GTEST_SKIP() << "built without libzstd";
  }
  for (const std::size_t given : {1U, 2U, 7U, 1000U}) {
    for (const std::size_t asked : {1U, 3U, 1000U}) {
      EXPECT_EQ(read(kZstd, given, asked), kText);
      EXPECT_EQ(read(std::string(kZstd) + std::string(kZstd), given, asked),
                std::string(kText) + std::string(kText));
    }
  }
  EXPECT_EQ(complaint_of_read(kZstd.substr(0, kZstd.size() - 1)),
            "p.csv: its zstd data end too early; accepted: a whole file of zstd");
  std::string damaged(kZstd);
  damaged.back() ^= 1;
  EXPECT_EQ(complaint_of_read(damaged),
            "p.csv: its zstd data are damaged; accepted: a whole file of zstd");
  // One octet, raw, behind a header that asks for a window of 2^(10 + 18) bytes (RFC
  // 8878, 3.1.1.1): refused whether the whole frame is there at once or not.
  const std::string too_large =
      std::string(kZstd) + std::string("\x28\xB5\x2F\xFD\x80\x90\x01\0\0\0\x09\0\0a", 14);
  for (const std::size_t given : {1U, 1000U}) {
    EXPECT_EQ(test::complaint_of([&] { read(too_large, given, 1000); }),
              "p.csv: its zstd data need a window of more than 128 MiB; accepted: a whole file of "
              "zstd");
  }
}

TEST(Compressed, WhatIsDamagedOrCutOffIsRefused) {
  for (std::size_t size = 4; size < kGzip.size(); ++size) {
    EXPECT_EQ(complaint_of_read(kGzip.substr(0, size)),
              "p.csv: its gzip data end too early; accepted: a whole file of gzip");
  }
  std::string damaged(kGzip);
  damaged[damaged.size() - 6] ^= 1;  // of the checksum
  EXPECT_EQ(complaint_of_read(damaged),
            "p.csv: its gzip data are damaged; accepted: a whole file of gzip");
}

TEST(Compressed, AFileIsAProfile) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "run.csv.gz", kGzip);
  hal::files::ProfileReader reader(open_input(folder / "run.csv.gz", "a profile"), "run.csv.gz");
  EXPECT_EQ(reader.bytes_total(), 0U);  // what is to come is not known
  const auto rows = reader.read_block();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].value, 41.5);
  EXPECT_EQ(rows[1].line, 3U);
}

}  // namespace
}  // namespace host_sim
