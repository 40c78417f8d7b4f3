// Extended models on the image: loaded over the bus, counted as on the host, refused with the
// reason.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "firmware/storage/slot.hpp"
#include "tests/virtual_g431/image.hpp"
#include "tests/virtual_g431/reference.hpp"
#include "tests/virtual_g431/tester.hpp"

namespace virtual_g431 {
namespace {

using lifemodel::extension::Effect;
using ::testing::ElementsAreArray;
using ::testing::IsEmpty;

constexpr PhaseCounts kRest{2061, 2040, 2049};

/// All that needs nothing but the motor current, and a correction, which acts on output tension
/// alone.
lifemodel::ExtendedParameters model_of_current() {
  lifemodel::ExtendedParameters model = Reference::compiled_in();
  lifemodel::extension::Extension& e = model.extension;
  e.current_offset = {838861};             // 0.05 A
  e.input_lag = {5 << 16};                 // 0.5 ms
  e.mean_stress = {134217728, 161061274};  // share 0.5, w 0.6
  e.bending_fatigue = {1 << 28, 30263298};
  e.endurance_limit = {214748365, -367143347};
  e.empirical.knots = lifemodel::extension::Empirical::kKnots;
  for (std::int32_t i = 0; i < e.empirical.knots; ++i) {
    e.empirical.knot[static_cast<std::size_t>(i)] = {i << 25, 302633 * i, -302633 * i};
  }
  for (const Effect effect :
       {Effect::current_offset, Effect::input_lag, Effect::mean_stress, Effect::bending_fatigue,
        Effect::endurance_limit, Effect::empirical}) {
    e.add(effect);
  }
  return model;
}

Bytes block_of(const lifemodel::ExtendedParameters& model) {
  const lifemodel::ExtendedBlock block(model);
  return {block.bytes().begin(), block.bytes().end()};
}

Bytes last_word(const Bytes& block) {
  return {block.end() - 4, block.end()};
}

class ExtendedModel : public Image {
 protected:
  /// A motor that turns at 20 Hz with 1 .. 5 A at 31 Hz for 1.5 s.
  PhaseCounts profile(Ticks time) const {
    const double time_s = to_ms(time - from_) / 1000;
    PhaseCounts counts = kRest;
    if (from_ == 0 || time_s < 0 || time_s > 1.5) {
      return counts;
    }
    const double amplitude = 102 + 68 * std::sin(2 * std::numbers::pi * 31 * time_s);
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const double angle = 2 * std::numbers::pi * (20 * time_s - static_cast<double>(i) / 3);
      counts[i] += static_cast<std::uint32_t>(std::lround(amplitude * std::cos(angle)));
    }
    return counts;
  }

  /// A board at rest with the power on.
  void start(Board& board) {
    from_ = 0;
    board.converters.signal = [this](Ticks time) { return profile(time); };
    board.power_on();
    board.run(300 * kMillisecond);
  }
  void restart(Board& board) {
    board.power_off();
    board.periods.clear();
    board.power_on();
    board.run(300 * kMillisecond);
  }
  /// Plays the profile, and holds every bit of the damage against the host.
  void expect_as_host(Board& board, const lifemodel::ExtendedParameters& model) {
    from_ = board.agenda.now();
    board.run(2 * kSecond);
    Reference reference(kRest, model);
    for (const Board::Period& period : board.periods) {
      reference.period(period.counts);
    }
    EXPECT_GT(reference.damage_ppb(), 1000u);
    expect_damage(board, reference.damage());
  }

  Ticks from_ = 0;
};

TEST_F(ExtendedModel, LoadedOverTheBusCountsAsOnTheHost) {
  Board board(contents);
  start(board);
  const Bytes block = block_of(model_of_current());
  EXPECT_THAT(Tester(board).load(block, kKey), ElementsAreArray(bytes({0x71, 0x01, 0x02, 0x03})));
  restart(board);
  Bytes configuration = bytes({0x62, 0x02, 0x20});
  const Bytes crc = last_word(block);
  configuration.insert(configuration.end(), crc.begin(), crc.end());
  EXPECT_THAT(Tester(board).read(0x0220), ElementsAreArray(configuration));
  EXPECT_THAT(Tester(board).read(0x0260),
              ElementsAreArray(bytes({0x62, 0x02, 0x60, 2, 0, 0, 0, 0, 0, 0, 0})));
  expect_as_host(board, model_of_current());
  EXPECT_FALSE(reported(board, protocol::EmergencyCode::parameters));
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

TEST_F(ExtendedModel, ThatNeedsWhatIsNotMeasuredIsRefusedAndTheOneBeforeCounts) {
  Board board(contents);
  start(board);
  lifemodel::ExtendedParameters warm = model_of_current();
  warm.extension.torque_gain = {1073742, 20 << 16};
  warm.extension.add(Effect::torque_gain);
  const Bytes block = block_of(warm);
  Tester tester(board);
  EXPECT_THAT(tester.load(block, kKey), ElementsAreArray(bytes({0x7F, 0x31, 0x31})));
  // Effect 11 needs the temperature of the winding, 4.
  Bytes reason = bytes({0x62, 0x02, 0x60, 1, 5, 11, 4});
  const Bytes crc = last_word(block);
  reason.insert(reason.end(), crc.begin(), crc.end());
  EXPECT_THAT(tester.read(0x0260), ElementsAreArray(reason));
  // A line of the log: event 11, tendon 0, epoch 0, and the block.
  const Bytes line = tester.read(0x1000);
  ASSERT_EQ(line.size(), 3u + 16u);
  EXPECT_EQ(line[3 + 8], std::byte{11});
  EXPECT_TRUE(std::equal(crc.begin(), crc.end(), line.begin() + 3 + 12));
  board.run(300 * kMillisecond);
  EXPECT_TRUE(reported(board, protocol::EmergencyCode::parameters));
  expect_as_host(board, Reference::compiled_in());
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

/// Cut in the first, in an early, a middle and the last of its 80 double words.
TEST_F(ExtendedModel, ThatIsCutWhileItIsWrittenIsToldAndTheOneBeforeCounts) {
  constexpr storage::FlashLayout kLayout;
  constexpr std::uint32_t kFrom = (kNodePageOffset / kPageBytes + 1 + kLayout.parameters.first);
  Board board(contents);
  start(board);
  const Bytes before = Tester(board).read(0x0220);
  ASSERT_EQ(before.size(), 7u);
  const Bytes block = block_of(model_of_current());
  for (const unsigned cut : {1u, 5u, 40u, 80u}) {
    Tester tester(board);
    ASSERT_TRUE(tester.transfer(block));
    unsigned programmed = 0;
    board.flash.on_begin = [&programmed](const Flash::Operation& operation) {
      const bool of_parameters = operation.offset / kPageBytes >= kFrom &&
                                 operation.offset / kPageBytes < kFrom + kLayout.parameters.count;
      programmed += !operation.erases && of_parameters ? 1 : 0;
    };
    tester.send(tester.prove(0x0203, bytes({0}), kKey, 0, block));
    ASSERT_TRUE(board.run_until([&] { return programmed == cut; }, kSecond, 10 * kMicrosecond));
    board.can.heard.clear();
    restart(board);
    board.flash.on_begin = [](const Flash::Operation&) {};
    EXPECT_THAT(Tester(board).read(0x0220), ElementsAreArray(before)) << cut;
    EXPECT_THAT(Tester(board).read(0x0260),
                ElementsAreArray(bytes({0x62, 0x02, 0x60, 1, 1, 0, 0, 0, 0, 0, 0})))
        << cut;
    EXPECT_TRUE(reported(board, protocol::EmergencyCode::parameters)) << cut;
    EXPECT_TRUE(board.drive_enabled());
  }
  EXPECT_THAT(Tester(board).load(block, kKey), ElementsAreArray(bytes({0x71, 0x01, 0x02, 0x03})));
  board.can.heard.clear();
  restart(board);
  EXPECT_FALSE(reported(board, protocol::EmergencyCode::parameters));
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

}  // namespace
}  // namespace virtual_g431
