#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>
#include <thread>

#include "hal/files/profile.hpp"

namespace {

thread_local std::uint64_t allocations = 0;

void* allocate(std::size_t size) {
  ++allocations;
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  return memory;
}

}  // namespace

void* operator new(std::size_t size) {
  return allocate(size);
}
void* operator new[](std::size_t size) {
  return allocate(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace host_sim {

using hal::files::ProfileReader;
using hal::files::ProfileRow;

namespace {

constexpr std::uint64_t kStreamBytes = 200'000'000;
constexpr std::size_t kRowBytes = 20;

void put_decimal(char* last, std::uint64_t value) {
  for (; value != 0; value /= 10) {
    *last-- = static_cast<char>('0' + value % 10);
  }
}

// Writes rows `0000000001.0,38.500\n`, in constant memory.
void write_stream(int descriptor) {
  const std::string header = "time_s,input_tension_N\n";
  ASSERT_EQ(::write(descriptor, header.data(), header.size()), static_cast<ssize_t>(header.size()));
  constexpr std::size_t kRows = 3000;
  std::array<char, kRows * kRowBytes> block{};
  std::uint64_t row = 0;
  for (std::uint64_t sent = 0; sent < kStreamBytes; sent += block.size()) {
    for (std::size_t i = 0; i < kRows; ++i) {
      char* const at = block.data() + i * kRowBytes;
      std::string_view("0000000000.0,38.500\n").copy(at, kRowBytes);
      put_decimal(at + 9, row++);
    }
    const char* from = block.data();
    const char* const end = from + block.size();
    while (from != end) {
      const ssize_t count = ::write(descriptor, from, static_cast<std::size_t>(end - from));
      ASSERT_GT(count, 0);
      from += count;
    }
  }
  ::close(descriptor);
}

std::int64_t peak_memory_KiB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST(ProfileMemory, IsConstantForALongStream) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  std::thread writer(write_stream, ends[1]);
  std::uint64_t rows_read = 0;
  std::uint64_t allocations_before = 0;
  std::int64_t memory_before_KiB = 0;
  {
    ProfileReader reader("/dev/fd/" + std::to_string(ends[0]));
    std::array<ProfileRow, 4096> rows{};
    rows_read += reader.read(rows);
    allocations_before = allocations;
    memory_before_KiB = peak_memory_KiB();
    while (const std::size_t count = reader.read(rows)) {
      rows_read += count;
    }
    EXPECT_GE(reader.bytes_read(), kStreamBytes);
  }
  EXPECT_EQ(allocations, allocations_before);
  EXPECT_LT(peak_memory_KiB() - memory_before_KiB, 4096);
  writer.join();
  ::close(ends[0]);
  EXPECT_GE(rows_read, kStreamBytes / kRowBytes);
}

}  // namespace
}  // namespace host_sim
