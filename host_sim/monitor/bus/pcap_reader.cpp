#include "host_sim/monitor/bus/pcap_reader.hpp"

#include <pcap/pcap.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <span>
#include <utility>

#include "hal/files/input_error.hpp"
#include "host_sim/monitor/bus/can_packet.hpp"

namespace host_sim::monitor {

using hal::files::InputError;

namespace {

constexpr std::string_view kAcceptedCapture =
    "PCAP or PCAPNG with whole packets of link type CAN_SOCKETCAN, LINUX_SLL or LINUX_SLL2";
constexpr std::int64_t kLatest_s = 0xffff'ffff;  // what PCAP has room for
constexpr unsigned kCan = 0x000c;                // linux/if_ether.h, ETH_P_CAN and ETH_P_CANFD
constexpr unsigned kCanFd = 0x000d;

struct Cooked {
  std::size_t head = 0;      ///< bytes before the frame
  std::size_t protocol = 0;  ///< where its kind lies, two bytes, the high one first
};

std::optional<Cooked> cooked_of(int link_type) {
  switch (link_type) {
    case DLT_LINUX_SLL:
      return Cooked{.head = 16, .protocol = 14};
    case DLT_LINUX_SLL2:
      return Cooked{.head = 20, .protocol = 0};
    default:
      return std::nullopt;
  }
}

}  // namespace

bool is_pcap(std::string_view front) {
  using namespace std::string_view_literals;
  const std::string_view magic = front.substr(0, 4);
  return magic == "\xd4\xc3\xb2\xa1"sv || magic == "\xa1\xb2\xc3\xd4"sv ||
         magic == "\x4d\x3c\xb2\xa1"sv || magic == "\xa1\xb2\x3c\x4d"sv ||
         magic == "\x0a\x0d\x0d\x0a"sv;
}

PcapReader::PcapReader(const std::filesystem::path& path)
    : name_(path.string()), capture_(nullptr, ::pcap_close) {
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) {
    throw InputError(name_, 0, 0, std::string("cannot be opened: ") + std::strerror(errno),
                     kAcceptedCapture);
  }
  open(file);
}

PcapReader::PcapReader(std::FILE* file, std::string name)
    : name_(std::move(name)), capture_(nullptr, ::pcap_close) {
  open(file);
}

PcapReader::~PcapReader() = default;

void PcapReader::open(std::FILE* file) {
  std::array<char, PCAP_ERRBUF_SIZE> error{};
  capture_.reset(
      ::pcap_fopen_offline_with_tstamp_precision(file, PCAP_TSTAMP_PRECISION_NANO, error.data()));
  if (!capture_) {
    std::fclose(file);
    throw InputError(name_, 0, 0, error.data(), kAcceptedCapture);
  }
  link_type_ = ::pcap_datalink(capture_.get());
  if (link_type_ != DLT_CAN_SOCKETCAN && !cooked_of(link_type_)) {
    const char* const name = ::pcap_datalink_val_to_name(link_type_);
    throw InputError(name_, 0, 0, std::string("link type ") + (name != nullptr ? name : "unknown"),
                     kAcceptedCapture);
  }
}

std::optional<SeenFrame> PcapReader::next() {
  for (;;) {
    ::pcap_pkthdr* head = nullptr;
    const u_char* bytes = nullptr;
    const int result = ::pcap_next_ex(capture_.get(), &head, &bytes);
    if (result == PCAP_ERROR_BREAK) {
      return std::nullopt;
    }
    ++packet_;
    if (result != 1) {
      refuse(std::string(": ") + ::pcap_geterr(capture_.get()));
    }
    auto seen = frame_in(std::span(reinterpret_cast<const std::byte*>(bytes), head->caplen));
    if (seen) {
      seen->time_ns = time_of(*head);
      return seen;
    }
  }
}

std::optional<SeenFrame> PcapReader::frame_in(std::span<const std::byte> packet) const {
  PacketKind kind = PacketKind::as_flag_says;
  if (const auto cooked = cooked_of(link_type_)) {
    if (packet.size() < cooked->head) {
      refuse(" is cut short");
    }
    const unsigned protocol = std::to_integer<unsigned>(packet[cooked->protocol]) << 8 |
                              std::to_integer<unsigned>(packet[cooked->protocol + 1]);
    if (protocol != kCan && protocol != kCanFd) {
      return std::nullopt;
    }
    kind = protocol == kCanFd ? PacketKind::flexible : PacketKind::classic;
    packet = packet.subspan(cooked->head);
  }
  std::optional<SeenFrame> seen = frame_of_packet(packet, true, kind);
  if (!seen) {
    refuse(" is cut short, or has no length of a CAN frame");
  }
  return seen;
}

std::int64_t PcapReader::time_of(const ::pcap_pkthdr& head) const {
  const std::int64_t seconds = head.ts.tv_sec;
  const std::int64_t fraction_ns = head.ts.tv_usec;
  if (seconds < 0 || seconds > kLatest_s || fraction_ns < 0 || fraction_ns >= 1'000'000'000) {
    refuse(" has a time that is none");
  }
  return seconds * 1'000'000'000 + fraction_ns;
}

void PcapReader::refuse(std::string_view trouble) const {
  throw InputError(name_, 0, 0, "packet " + std::to_string(packet_) + std::string(trouble),
                   kAcceptedCapture);
}

}  // namespace host_sim::monitor
