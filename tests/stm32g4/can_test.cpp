#include <gtest/gtest.h>

#include <array>

#include "hal/stm32g4/can_controller.hpp"
#include "tests/stm32g4/model/chip.hpp"

namespace stm32g4_models {
namespace {

using hal::CanFrame;
using hal::CanState;
using hal::Error;

CanFrame frame(std::uint32_t id, bool extended, std::initializer_list<int> bytes) {
  CanFrame result;
  result.id = id;
  result.extended = extended;
  for (const int byte : bytes) {
    result.data[result.length++] = static_cast<std::byte>(byte);
  }
  return result;
}

class Can : public ::testing::Test {
 protected:
  ReadyChip chip;
  hal::stm32g4::CanController<Word> can{chip.can.registers, chip.message_ram.registers};

  void SetUp() override { ASSERT_EQ(can.start({0x205, 0x18DA05F1}), Error::none); }
};

TEST_F(Can, RunsAtOneMegabitWithTheSamplePointOfCanopen) {
  EXPECT_EQ(chip.can.bit_rate(), 1'000'000u);
  // CiA 301, table 2: 87.5 %.
  EXPECT_NEAR(chip.can.sample_point(), 875, 5);
  EXPECT_TRUE(chip.can.on_bus());
}

TEST_F(Can, FiltersLieInTheMessageRamAsTheManualSays) {
  const auto* words = reinterpret_cast<const Word*>(&chip.message_ram.registers);
  // RM0440 44.3.9: mask filter (10), into FIFO 0 (001), id 0x205, all 11 bits count.
  EXPECT_EQ(words[0].held(), 0x8A0507FFu);
  for (std::size_t i = 1; i < 28; ++i) {
    EXPECT_EQ(words[i].held(), 0u);
  }
  // RM0440 44.3.10: into FIFO 0 (001), then mask filter (10), all 29 bits count.
  EXPECT_EQ(words[0x70 / 4].held(), 0x38DA05F1u);
  EXPECT_EQ(words[0x74 / 4].held(), 0x9FFFFFFFu);
  // RM0440 44.4.19: one filter of each kind, all else and remote frames rejected.
  EXPECT_EQ(chip.can.registers.rxgfc.held(), 0x0101002Bu);
}

TEST_F(Can, SendsAStandardFrame) {
  ASSERT_EQ(can.send(frame(0x185, false, {1, 2, 3, 4, 5, 6, 7, 8})), Error::none);
  const auto* words = reinterpret_cast<const Word*>(&chip.message_ram.registers);
  // RM0440 44.3.7: id at bit 18, length at bit 16 of the next word, then little-endian data.
  EXPECT_EQ(words[0x278 / 4].held(), 0x185u << 18);
  EXPECT_EQ(words[0x27C / 4].held(), 8u << 16);
  EXPECT_EQ(words[0x280 / 4].held(), 0x04030201u);
  EXPECT_EQ(words[0x284 / 4].held(), 0x08070605u);
  ASSERT_TRUE(chip.can.transmit());
}

TEST_F(Can, SendsAnExtendedFrameFromTheNextBuffer) {
  ASSERT_EQ(can.send(frame(0x705, false, {5})), Error::none);
  ASSERT_EQ(can.send(frame(0x18DAF105, true, {0x02, 0x7E, 0x00})), Error::none);
  const auto* words = reinterpret_cast<const Word*>(&chip.message_ram.registers);
  // An element has 18 words.
  EXPECT_EQ(words[(0x278 + 72) / 4].held(), 0x58DAF105u);
  EXPECT_EQ(words[(0x278 + 72) / 4 + 1].held(), 3u << 16);
  EXPECT_EQ(words[(0x278 + 72) / 4 + 2].held(), 0x00007E02u);
}

TEST_F(Can, FullQueueChangesNothingAndOrderIsKept) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    ASSERT_EQ(can.send(frame(0x100 + i, false, {})), Error::none);
  }
  EXPECT_EQ(can.send(frame(0x1FF, false, {})), Error::full);
  EXPECT_EQ(chip.can.transmit()->header0 >> 18, 0x100u);
  EXPECT_EQ(can.send(frame(0x103, false, {})), Error::none);
  for (std::uint32_t i = 1; i < 4; ++i) {
    EXPECT_EQ(chip.can.transmit()->header0 >> 18, 0x100 + i);
  }
  EXPECT_FALSE(chip.can.transmit());
}

TEST_F(Can, ReceivesWhatTheFiltersLetThrough) {
  chip.can.deliver_standard(0x205, 2, 0x00000301);
  chip.can.deliver_standard(0x206, 2, 0xFFFFFFFF);
  chip.can.deliver(1u << 30 | 0x18DA05F1, 8u << 16, 0x44332211, 0x88776655);
  chip.can.deliver(1u << 30 | 0x18DA06F1, 8u << 16);
  chip.can.deliver(1u << 29 | 0x205u << 18, 0);
  EXPECT_FALSE(can.receive()) << "before the interrupt";
  can.isr_receive();
  EXPECT_EQ(can.receive(), frame(0x205, false, {1, 3}));
  EXPECT_EQ(can.receive(),
            frame(0x18DA05F1, true, {0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77, 0x88}));
  EXPECT_FALSE(can.receive());
  EXPECT_EQ(can.status().lost, 0u);
}

TEST_F(Can, BytesPastTheLengthAreZeroAndALongLengthMeansEight) {
  chip.can.deliver_standard(0x205, 1, 0xFFFFFFFF, 0xFFFFFFFF);
  chip.can.deliver_standard(0x205, 15, 0x01010101, 0x02020202);
  can.isr_receive();
  EXPECT_EQ(can.receive(), frame(0x205, false, {0xFF}));
  EXPECT_EQ(can.receive(), frame(0x205, false, {1, 1, 1, 1, 2, 2, 2, 2}));
}

TEST_F(Can, TwoFramesAPeriodAreNeverLost) {
  for (std::uint32_t i = 0; i < 100; ++i) {
    chip.can.deliver_standard(0x205, 4, 2 * i);
    chip.can.deliver_standard(0x205, 4, 2 * i + 1);
    can.isr_receive();
    for (std::uint32_t j = 0; j < 2; ++j) {
      const auto got = can.receive();
      ASSERT_TRUE(got);
      EXPECT_EQ(std::to_integer<std::uint32_t>(got->data[0]), 2 * i + j);
    }
  }
  EXPECT_EQ(can.status().lost, 0u);
}

TEST_F(Can, CountsWhatFindsNoRoom) {
  for (int i = 0; i < 4; ++i) {
    chip.can.deliver_standard(0x205);
  }
  can.isr_receive();
  EXPECT_EQ(can.status().lost, 1u) << "the fourth in the hardware";
  for (std::size_t i = 3; i < hal::stm32g4::CanController<Word>::kMailbox; ++i) {
    chip.can.deliver_standard(0x205);
    can.isr_receive();
  }
  EXPECT_EQ(can.status().lost, 1u);
  chip.can.deliver_standard(0x205);
  can.isr_receive();
  EXPECT_EQ(can.status().lost, 2u) << "the one past the mailbox";
  for (std::size_t i = 0; i < hal::stm32g4::CanController<Word>::kMailbox; ++i) {
    EXPECT_TRUE(can.receive());
  }
  EXPECT_FALSE(can.receive());
}

TEST_F(Can, TellsTheStatesOfFaultConfinement) {
  EXPECT_EQ(can.status(), hal::CanStatus{});
  chip.can.set_errors(95, 95);
  EXPECT_EQ(can.status().state, CanState::active);
  chip.can.set_errors(96, 0);
  EXPECT_EQ(can.status().state, CanState::warning);
  EXPECT_EQ(can.status().transmit_errors, 96);
  chip.can.set_errors(0, 127);
  EXPECT_EQ(can.status().state, CanState::warning);
  EXPECT_EQ(can.status().receive_errors, 127);
  chip.can.set_errors(0, 200);
  EXPECT_EQ(can.status().state, CanState::passive);
  EXPECT_EQ(can.status().receive_errors, 128);
  chip.can.set_errors(128, 0);
  EXPECT_EQ(can.status().state, CanState::passive);
}

TEST_F(Can, GoesOffAndComesBackWhenAsked) {
  ASSERT_EQ(can.send(frame(0x100, false, {})), Error::none);
  chip.can.go_bus_off();
  can.isr_receive();
  can.isr_receive();
  EXPECT_EQ(can.status().state, CanState::off);
  EXPECT_EQ(can.status().bus_offs, 1u);
  EXPECT_EQ(can.send(frame(0x101, false, {})), Error::off);
  EXPECT_FALSE(chip.can.transmit());

  chip.can.idle_bus();
  EXPECT_EQ(can.status().state, CanState::off) << "it waits until it is asked";
  EXPECT_EQ(can.recover(), Error::none);
  EXPECT_EQ(can.send(frame(0x101, false, {})), Error::off) << "129 times 11 bits are not over";
  static_cast<void>(can.status());
  chip.can.idle_bus();
  can.isr_receive();
  EXPECT_EQ(can.status().state, CanState::active);
  static_cast<void>(can.recover());
  EXPECT_EQ(can.send(frame(0x102, false, {})), Error::none);
  EXPECT_EQ(chip.can.transmit()->header0 >> 18, 0x100u) << "what waited leaves first";
  EXPECT_EQ(chip.can.transmit()->header0 >> 18, 0x102u);

  chip.can.go_bus_off();
  can.isr_receive();
  EXPECT_EQ(can.status().bus_offs, 2u);
}

TEST_F(Can, RecoveringWhatIsNotOffChangesNothing) {
  EXPECT_EQ(can.recover(), Error::none);
  EXPECT_TRUE(chip.can.on_bus());
  EXPECT_EQ(can.send(frame(0x100, false, {})), Error::none);
}

}  // namespace
}  // namespace stm32g4_models
