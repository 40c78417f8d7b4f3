#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>

namespace host_sim::monitor::test {

/// Numbers as files of captures hold them, written down after the descriptions of the formats
/// (draft-ietf-opsawg-pcap, draft-ietf-opsawg-pcapng), little-endian.
inline std::string le(std::uint64_t value, int bytes) {
  std::string out;
  for (int i = 0; i < bytes; ++i) {
    out += static_cast<char>((value >> (8 * i)) & 0xff);
  }
  return out;
}
inline std::string raw(std::initializer_list<int> values) {
  std::string out;
  for (const int value : values) {
    out += static_cast<char>(value);
  }
  return out;
}

inline std::string pcap_head(std::uint32_t link_type, std::uint32_t magic = 0xa1b2c3d4) {
  return le(magic, 4) + le(2, 2) + le(4, 2) + le(0, 8) + le(65'535, 4) + le(link_type, 4);
}
inline std::string pcap_packet(std::uint32_t seconds, std::uint32_t fraction,
                               const std::string& packet) {
  return le(seconds, 4) + le(fraction, 4) + le(packet.size(), 4) + le(packet.size(), 4) + packet;
}

/// Section header, one interface with times in ns, and a packet of 12 bytes or more.
inline std::string pcapng(std::uint16_t link_type, std::uint64_t time_ns,
                          const std::string& packet) {
  const auto block = [](std::uint32_t kind, std::string body) {
    body.resize((body.size() + 3) / 4 * 4, '\0');
    const std::string length = le(body.size() + 12, 4);
    return le(kind, 4) + length + body + length;
  };
  const std::string resolution = le(9, 2) + le(1, 2) + raw({9, 0, 0, 0}) + le(0, 4);
  return block(0x0a0d0d0a, le(0x1a2b3c4d, 4) + le(1, 2) + le(0, 2) + le(~std::uint64_t{0}, 8)) +
         block(1, le(link_type, 2) + le(0, 2) + le(0, 4) + resolution) +
         block(6, le(0, 4) + le(time_ns >> 32, 4) + le(time_ns & 0xffff'ffff, 4) +
                      le(packet.size(), 4) + le(packet.size(), 4) + packet);
}

}  // namespace host_sim::monitor::test
