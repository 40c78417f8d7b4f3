#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "host_sim/monitor/bus/frame_log.hpp"

struct pcap;
struct pcap_pkthdr;

namespace host_sim::monitor {

/// Whether bytes that begin so are PCAP or PCAPNG.
bool is_pcap(std::string_view front);

/// A capture of a CAN interface, read by libpcap: link types CAN_SOCKETCAN, LINUX_SLL and
/// LINUX_SLL2. Packets of a cooked capture that are no CAN are skipped; one that is cut short is
/// refused.
class PcapReader final : public LogReader {
 public:
  /// @throws InputError
  explicit PcapReader(const std::filesystem::path& path);
  /// Reads from an open file, and closes it. `name` stands for the file in errors.
  PcapReader(std::FILE* file, std::string name);
  ~PcapReader() override;

  std::optional<SeenFrame> next() override;

 private:
  void open(std::FILE* file);
  /// The frame in a packet, without a time; nothing where the packet is no CAN.
  std::optional<SeenFrame> frame_in(std::span<const std::byte> packet) const;
  std::int64_t time_of(const ::pcap_pkthdr& head) const;
  /// The packet read last ` is cut short`, or the like.
  [[noreturn]] void refuse(std::string_view trouble) const;

  std::string name_;
  std::uint64_t packet_ = 0;  ///< number of the last one, from 1
  int link_type_ = 0;
  std::unique_ptr<pcap, void (*)(pcap*)> capture_;
};

}  // namespace host_sim::monitor
