#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "hal/can_frame.hpp"
#include "tests/virtual_g431/board/agenda.hpp"
#include "tests/virtual_g431/board/clocks.hpp"
#include "tests/virtual_g431/board/peripheral.hpp"

namespace virtual_g431 {

/// Bits on the wire of classic CAN with its stuff bits, from the start of frame to the end of the
/// intermission (ISO 11898-1).
std::uint32_t bits_on_wire(const hal::CanFrame& frame);

/// FDCAN1 with its message RAM (RM0440 44) on a bus of 1 Mbit/s with one other node, the tester.
/// Whoever has the lower identifier sends first.
class CanController : public Peripheral {
 public:
  enum class Bus { sound, nobody_else, shorted };
  struct Heard {
    Ticks at;  ///< the end of the frame
    hal::CanFrame frame;
  };

  CanController(Agenda& agenda, Rules& rules, const Clocks& clocks)
      : agenda_(agenda), rules_(rules), clocks_(clocks) {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

  /// The message RAM has its own base address.
  class MessageRam : public Peripheral {
   public:
    explicit MessageRam(CanController& owner) : owner_(owner) {}
    std::uint32_t read(std::uint32_t offset) override { return owner_.ram_[offset / 4 % kWords]; }
    void write(std::uint32_t offset, std::uint32_t value) override {
      owner_.write_ram(offset, value);
    }
    /// It has no reset value (RM0440 44.3.3).
    void reset() override {}

   private:
    CanController& owner_;
  };
  MessageRam ram{*this};
  void fill_ram(std::function<std::uint32_t()> junk) {
    for (std::uint32_t& word : ram_) {
      word = junk();
    }
  }

  /// The tester sends as soon as the bus lets it.
  void send(const hal::CanFrame& frame) {
    tester_.push_back(frame);
    look();
  }
  [[nodiscard]] std::size_t waiting() const { return tester_.size(); }
  void set_bus(Bus bus) {
    bus_ = bus;
    look();
  }
  /// Whether the transceiver is on; without it the node neither hears nor is heard.
  std::function<bool()> transceiver_on = [] { return true; };

  /// All that the node has sent.
  std::vector<Heard> heard;
  std::function<void(const Heard&)> on_heard = [](const Heard&) {};

 private:
  static constexpr std::size_t kWords = 0x350 / 4;
  static constexpr std::uint32_t kFifo = 3;

  [[nodiscard]] bool init() const { return (cccr_ & 1) != 0; }
  [[nodiscard]] bool configurable() const { return (cccr_ & 3) == 3; }
  [[nodiscard]] bool on_bus() const { return !init() && joined_ && !bus_off_; }
  void write_cccr(std::uint32_t value);
  void write_ram(std::uint32_t offset, std::uint32_t value);
  void request(std::uint32_t mask);
  void join();
  /// Starts the next frame where the bus is free.
  void look();
  [[nodiscard]] std::optional<hal::CanFrame> first_request();
  void sent(const hal::CanFrame& frame);
  void failed();
  void take(const hal::CanFrame& frame);
  [[nodiscard]] bool accepts(const hal::CanFrame& frame);
  [[nodiscard]] Ticks bit_time() const;

  Agenda& agenda_;
  Rules& rules_;
  const Clocks& clocks_;
  std::array<std::uint32_t, kWords> ram_{};
  std::uint32_t cccr_ = 1, nbtp_ = 0, rxgfc_ = 0, txbc_ = 0, ckdiv_ = 0;
  std::uint32_t ir_ = 0, ie_ = 0, ils_ = 0, ile_ = 0;
  std::uint32_t transmit_errors_ = 0, receive_errors_ = 0;
  std::uint32_t pending_ = 0, done_ = 0;
  std::uint32_t put_ = 0, get_ = 0, level_ = 0;
  std::uint32_t rx_put_ = 0, rx_get_ = 0, rx_level_ = 0;
  bool rx_lost_ = false;
  bool joined_ = false;
  bool bus_off_ = false;
  Ticks init_seen_at_ = 0;
  std::uint64_t life_ = 0;

  Bus bus_ = Bus::sound;
  bool busy_ = false;
  std::deque<hal::CanFrame> tester_;
};

}  // namespace virtual_g431
