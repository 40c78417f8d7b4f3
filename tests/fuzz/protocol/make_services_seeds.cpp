// make_services_seeds FOLDER: writes the seeds of fuzz_isotp and fuzz_uds.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/protocol/services/requests.hpp"

namespace {

using protocol::testing::Bytes;
using protocol::testing::hex;
using protocol::testing::paper_block;
using protocol::testing::operator+;

namespace fs = std::filesystem;

void write(const fs::path& path, const Bytes& bytes) {
  fs::create_directories(path.parent_path());
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
}

/// A request of fuzz_uds.
Bytes request(const Bytes& bytes, bool sign) {
  const auto head = static_cast<std::byte>(bytes.size() | (sign ? 0x80u : 0u));
  return Bytes{head} + bytes;
}

Bytes start(std::string_view head, const Bytes& arguments) {
  return hex(head) + arguments + Bytes(12, std::byte{0});
}

void write_isotp(const fs::path& folder) {
  write(folder / "single", hex("03 02 3e 00 80"));
  write(folder / "long", hex("08 10 0a 00 01 02 03 04 05 80 05 21 06 07 08 09"));
  write(folder / "too_long", hex("08 10 29 00 01 02 03 04 05 80"));
  write(folder / "escape", hex("08 10 00 00 01 00 00 04 05 80"));
  write(folder / "send", hex("9f 80 03 30 00 00 80 80 80 80 80"));
  write(folder / "wait", hex("9f 80 03 31 00 00 03 30 01 f5 80 41 80 03 32 00 00"));
  write(folder / "timeouts", hex("9f 80 08 10 0a 00 01 02 03 04 05 80 7f 80 7f 80"));
  write(folder / "wrong_sequence", hex("08 10 14 00 01 02 03 04 05 80 08 22 00 00 00 00 00 00 00"));
}

void write_uds(const fs::path& folder) {
  write(folder / "tester_present", request(hex("3e 00"), false) + request(hex("3e 80"), false));
  for (const auto* identifiers : {"0200", "0220", "0240 0241", "0242", "1000", "f18c f195"}) {
    std::string name = identifiers;
    std::erase(name, ' ');
    write(folder / ("read_" + name), request(hex("22") + hex(identifiers), false));
  }
  const Bytes open = start("31 01 02 01", hex("01"));
  const Bytes load = start("31 01 02 02", hex("00") + paper_block());
  write(folder / "open", request(open, true));
  write(folder / "open_unsigned", request(open, false));
  write(folder / "open_twice", request(open, true) + request(open, true));
  write(folder / "load", request(load, true) + request(hex("22 10 00"), false));
  write(folder / "load_unsigned", request(load, false));
  const Bytes block = paper_block();
  const Bytes parts = request(hex("34 00 21 00 00 54"), false) +
                      request(hex("36 01") + Bytes(block.begin(), block.begin() + 60), false) +
                      request(hex("36 02") + Bytes(block.begin() + 60, block.end()), false) +
                      request(hex("37"), false);
  const Bytes load_parts = start("31 01 02 03", hex("00"));
  write(folder / "transfer", parts + request(load_parts, true) + request(hex("22 02 60"), false));
  write(folder / "transfer_unsigned", parts + request(load_parts, false));
  write(folder / "lock_out", request(open, false) + request(open, false) + request(open, false) +
                                 request(open, true) + request(hex("22 02 42"), false));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_services_seeds FOLDER\n", stderr);
    return 2;
  }
  write_isotp(fs::path(argv[1]) / "fuzz_isotp");
  write_uds(fs::path(argv[1]) / "fuzz_uds");
  return 0;
}
