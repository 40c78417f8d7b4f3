#include "firmware/boards/qemu_mps2/semihosting.hpp"

#include <array>

namespace boards::qemu_mps2 {
namespace {

enum class Operation : std::uint32_t {
  open = 0x01,
  close = 0x02,
  write0 = 0x04,
  write = 0x05,
  read = 0x06,
  seek = 0x0a,
  get_command_line = 0x15,
  exit_extended = 0x20,
};

std::uint32_t call(Operation operation, const void* argument) {
  register std::uint32_t r0 __asm__("r0") = static_cast<std::uint32_t>(operation);
  register const void* r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

std::uint32_t word(const volatile void* pointer) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(pointer));
}

std::size_t length(const char* text) {
  std::size_t size = 0;
  while (text[size] != '\0') {
    ++size;
  }
  return size;
}

}  // namespace

extern "C" [[noreturn]] void exit(int code) {
  constexpr std::uint32_t kApplicationExit = 0x20026;
  const std::array<std::uint32_t, 2> block{kApplicationExit, static_cast<std::uint32_t>(code)};
  for (;;) {
    call(Operation::exit_extended, block.data());
  }
}

void write(const char* text) {
  call(Operation::write0, text);
}

std::size_t command_line(std::span<char> out) {
  std::array<std::uint32_t, 2> block{word(out.data()), static_cast<std::uint32_t>(out.size())};
  return call(Operation::get_command_line, block.data()) == 0 ? block[1] : 0;
}

HostFile::HostFile(const char* path, Mode mode) {
  const std::array<std::uint32_t, 3> block{word(path), static_cast<std::uint32_t>(mode),
                                           static_cast<std::uint32_t>(length(path))};
  handle_ = call(Operation::open, block.data());
}

HostFile::~HostFile() {
  if (is_open()) {
    call(Operation::close, &handle_);
  }
}

std::size_t HostFile::read(std::span<std::byte> out) {
  const auto size = static_cast<std::uint32_t>(out.size());
  const std::array<std::uint32_t, 3> block{handle_, word(out.data()), size};
  const std::uint32_t missing = call(Operation::read, block.data());
  return missing > size ? 0 : size - missing;
}

bool HostFile::seek(std::uint32_t position) {
  const std::array<std::uint32_t, 2> block{handle_, position};
  return call(Operation::seek, block.data()) == 0;
}

bool HostFile::write(std::span<const std::byte> bytes) {
  const std::array<std::uint32_t, 3> block{handle_, word(bytes.data()),
                                           static_cast<std::uint32_t>(bytes.size())};
  return call(Operation::write, block.data()) == 0;
}

}  // namespace boards::qemu_mps2
