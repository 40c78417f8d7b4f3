#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "hal/can_frame.hpp"
#include "hal/stm32g4/can_controller.hpp"
#include "tests/stm32g4/model/rcc_model.hpp"
#include "tests/stm32g4/model/word.hpp"

namespace stm32g4_models {

/// RM0440 44.3.3: memory of the controller, of which only words can be accessed.
class MessageRamModel : public RegisterModel<hal::stm32g4::MessageRam<Word>> {
 public:
  /// Transmit buffers that the controller owns.
  std::uint32_t pending = 0;

  void on_write(Word& word, std::uint32_t value) override {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto* buffer = &registers.tx_buffer[i];
      const bool inside = !std::less<>()(static_cast<const void*>(&word), buffer) &&
                          std::less<>()(static_cast<const void*>(&word), buffer + 1);
      EXPECT_FALSE(inside && (pending >> i & 1u) != 0) << "a buffer that waits was overwritten";
    }
    word.hold(value);
  }
};

/// RM0440 chapter 44, classic CAN alone.
class CanModel : public RegisterModel<hal::stm32g4::FdcanRegisters<Word>> {
 public:
  CanModel(const RccModel& rcc, MessageRamModel& ram) : rcc_(rcc), ram_(ram) {
    registers.cccr.hold(1);
    registers.nbtp.hold(0x06000A03);
    registers.psr.hold(0x707);
    registers.txfqs.hold(3);
  }

  [[nodiscard]] bool on_bus() const {
    return !registers.cccr.has(1) && !registers.psr.has(1u << 7);
  }
  [[nodiscard]] std::uint32_t bit_rate() const {
    const std::uint32_t t = registers.nbtp.held();
    EXPECT_EQ(rcc_.registers.ccipr.held() >> 24 & 3u, 2u) << "the kernel clock is not PCLK1";
    return rcc_.core_Hz() / ((t >> 16 & 0x1FFu) + 1) / (1 + quanta_before() + (t & 0x7Fu) + 1);
  }
  /// Sample point in thousandths of the bit.
  [[nodiscard]] std::uint32_t sample_point() const {
    const std::uint32_t after = (registers.nbtp.held() & 0x7Fu) + 1;
    return (1 + quanta_before()) * 1000 / (1 + quanta_before() + after);
  }

  /// Somebody else sends a frame, as header words and data.
  void deliver(std::uint32_t header0, std::uint32_t header1, std::uint32_t low = 0,
               std::uint32_t high = 0) {
    if (!on_bus() || !accepted(header0)) {
      return;
    }
    if (fifo_.size() == 3) {
      registers.ir.raise(1u << 2);
      registers.rxf0s.raise(1u << 25);
      return;
    }
    auto& element = ram_.registers.rx_fifo0[put_];
    element.header[0].hold(header0);
    element.header[1].hold(header1);
    element.data[0].hold(low);
    element.data[1].hold(high);
    fifo_.push_back(put_);
    put_ = (put_ + 1) % 3;
    update();
  }
  void deliver_standard(std::uint32_t id, std::uint32_t length = 0, std::uint32_t low = 0,
                        std::uint32_t high = 0) {
    deliver(id << 18, length << 16, low, high);
  }

  /// The oldest frame that waits to be sent leaves, as header words and data.
  struct Sent {
    std::uint32_t header0, header1, low, high;
  };
  std::optional<Sent> transmit() {
    if (!on_bus() || queue_.empty()) {
      return std::nullopt;
    }
    const std::size_t index = queue_.front();
    queue_.pop_front();
    ram_.pending &= ~(1u << index);
    update();
    const auto& element = ram_.registers.tx_buffer[index];
    return Sent{element.header[0].held(), element.header[1].held(), element.data[0].held(),
                element.data[1].held()};
  }

  void set_errors(std::uint32_t transmit, std::uint32_t receive) {
    const bool receive_passive = receive >= 128;
    registers.ecr.hold(transmit | (receive & 0x7Fu) << 8 | (receive_passive ? 1u << 15 : 0));
    registers.psr.drop(7u << 5);
    registers.psr.raise((transmit >= 96 || receive >= 96 ? 1u << 6 : 0) |
                        (transmit >= 128 || receive_passive ? 1u << 5 : 0));
  }
  /// 256 transmit errors: the controller leaves the bus and sets INIT (44.3.2).
  void go_bus_off() {
    registers.psr.raise(1u << 7);
    registers.cccr.raise(1);
    recovering_ = false;
  }
  /// 129 times 11 recessive bits.
  void idle_bus() {
    if (recovering_) {
      recovering_ = false;
      registers.psr.drop(7u << 5);
      registers.ecr.hold(0);
    }
  }

  std::uint32_t on_read(const Word& word) override {
    check_clock();
    if (&word == &registers.cccr && init_.due()) {
      registers.cccr.hold((registers.cccr.held() & ~1u) | (wanted_init_ ? 1u : 0u));
    }
    EXPECT_NE(&word, &registers.rxf0a);
    return word.held();
  }

  void on_write(Word& word, std::uint32_t value) override {
    check_clock();
    const bool protect = &word == &registers.nbtp || &word == &registers.rxgfc ||
                         &word == &registers.txbc || &word == &registers.ckdiv ||
                         &word == &registers.dbtp || &word == &registers.xidam;
    EXPECT_FALSE(protect && !registers.cccr.has(3)) << "set up without INIT and CCE (44.3.2)";
    if (&word == &registers.cccr) {
      return write_cccr(value);
    }
    if (&word == &registers.ir) {
      registers.ir.drop(value);
      return;
    }
    if (&word == &registers.rxf0a) {
      EXPECT_FALSE(fifo_.empty()) << "acknowledged what was not there";
      EXPECT_EQ(value, fifo_.front()) << "acknowledged another place than the oldest";
      fifo_.pop_front();
      update();
      return;
    }
    if (&word == &registers.txbar) {
      return request(value);
    }
    word.hold(value);
  }

 private:
  [[nodiscard]] std::uint32_t quanta_before() const {
    return (registers.nbtp.held() >> 8 & 0xFFu) + 1;
  }
  void check_clock() const {
    EXPECT_TRUE(rcc_.enabled(rcc_.registers.apb1enr1, 1u << 25)) << "FDCAN without its clock";
  }

  void write_cccr(std::uint32_t value) {
    if ((value & 2u) != 0 && !registers.cccr.has(2)) {
      EXPECT_TRUE(registers.cccr.has(1)) << "CCE while INIT does not read one (44.3.2)";
    }
    EXPECT_EQ(value & ~3u, 0u) << "classic CAN, normal operation";
    wanted_init_ = (value & 1u) != 0;
    const bool was = registers.cccr.has(1);
    registers.cccr.hold((was ? 1u : 0u) | (wanted_init_ ? value & 2u : 0u));
    if (wanted_init_ != was) {
      init_.begin(2);
    }
    recovering_ = recovering_ || (!wanted_init_ && registers.psr.has(1u << 7));
  }

  [[nodiscard]] bool accepted(std::uint32_t header0) const {
    const std::uint32_t rules = registers.rxgfc.held();
    const bool extended = (header0 & 1u << 30) != 0;
    if ((header0 & 1u << 29) != 0 && (rules >> (extended ? 0 : 1) & 1u) != 0) {
      return false;
    }
    for (std::size_t i = 0; !extended && i < (rules >> 16 & 0x1Fu); ++i) {
      const std::uint32_t f = ram_.registers.standard_filter[i].held();
      EXPECT_EQ(f >> 30, 2u) << "a mask filter";
      if ((f >> 27 & 7u) == 1 && ((header0 >> 18 ^ f >> 16) & f & 0x7FFu) == 0) {
        return true;
      }
    }
    for (std::size_t i = 0; extended && i < (rules >> 24 & 0xFu); ++i) {
      const std::uint32_t f0 = ram_.registers.extended_filter[i][0].held();
      const std::uint32_t f1 = ram_.registers.extended_filter[i][1].held();
      EXPECT_EQ(f1 >> 30, 2u) << "a mask filter";
      if (f0 >> 29 == 1 && ((header0 ^ f0) & f1 & 0x1FFFFFFFu) == 0) {
        return true;
      }
    }
    return (rules >> (extended ? 2 : 4) & 3u) == 0;
  }

  void request(std::uint32_t value) {
    EXPECT_FALSE(registers.cccr.has(1)) << "a request while INIT is set";
    EXPECT_EQ(value, 1u << next_) << "a request for another place than the next of the FIFO";
    EXPECT_LT(queue_.size(), 3u) << "a request to a full FIFO";
    queue_.push_back(next_);
    ram_.pending |= value;
    next_ = (next_ + 1) % 3;
    update();
  }

  void update() {
    registers.rxf0s.hold(static_cast<std::uint32_t>(
        fifo_.size() | (fifo_.empty() ? put_ : fifo_.front()) << 8 | put_ << 16));
    registers.txfqs.hold(static_cast<std::uint32_t>((3 - queue_.size()) | next_ << 16 |
                                                    (queue_.size() == 3 ? 1u << 21 : 0)));
    registers.txbrp.hold(ram_.pending);
  }

  const RccModel& rcc_;
  MessageRamModel& ram_;
  Delayed init_;
  bool wanted_init_ = true;
  bool recovering_ = false;
  std::deque<std::size_t> fifo_, queue_;
  std::size_t put_ = 0, next_ = 0;
};

}  // namespace stm32g4_models
