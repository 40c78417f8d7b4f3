#include <string_view>
#include <utility>

#include "hal/slcan/port.hpp"
#include "tests/hal/contract/can_port.hpp"
#include "tests/hal/slcan/wire.hpp"

namespace hal_test {
namespace {

namespace slcan = hal::slcan;

/// The host is the peer: it has opened the channel.
class SlcanNode {
 public:
  slcan::Port<slcan_test::Wire>& port() { return port_; }
  std::vector<hal::CanFrame> on_bus() {
    text_ += wire_.host_reads();
    std::vector<hal::CanFrame> frames;
    for (std::size_t end = text_.find('\r'); end != std::string::npos; end = text_.find('\r')) {
      const auto line = slcan::parse_frame(std::string_view(text_).substr(0, end));
      text_.erase(0, end + 1);
      if (line) {
        frames.push_back(line->frame);
      }
    }
    return frames;
  }
  void peer_sends(const hal::CanFrame& frame) {
    wire_.host_writes(slcan::format({frame, false}).view());
  }
  hal::CanFrame accepted(std::uint8_t n) { return frame(0x205, 8, n); }
  bool block() {
    wire_.set_room(40);
    return true;
  }
  bool unblock() {
    wire_.set_room(1'000'000);
    EXPECT_EQ(port_.receive(), std::nullopt);
    return true;
  }
  // Only the host closes the channel, and only the host opens it: no fault of a controller.
  bool go_off() { return false; }
  bool come_back() { return false; }

 private:
  slcan_test::Wire wire_;
  slcan::Port<slcan_test::Wire> port_{wire_, slcan::Channel::open};
  std::string text_;
};

INSTANTIATE_TYPED_TEST_SUITE_P(Slcan, CanPortContract, SlcanNode);

}  // namespace
}  // namespace hal_test
