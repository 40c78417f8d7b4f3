#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <numbers>

#include "tests/virtual_g431/image.hpp"
#include "tests/virtual_g431/stored.hpp"

namespace virtual_g431 {
namespace {

using ::testing::IsEmpty;

/// 1 .. 5 A at 40 Hz, whose phases add up to nothing: so much damage that every second is saved.
PhaseCounts load(Ticks time) {
  const double angle = 2 * std::numbers::pi * 40 * to_ms(time) / 1000;
  const auto counts = static_cast<std::uint32_t>(std::lround(98 + 60 * std::sin(angle)));
  return {2048 + 2 * (counts / 2), 2048 - counts / 2, 2048 - counts / 2};
}

/// A restart with what is in the flash: the first status that the board sends.
struct Restart {
  std::uint32_t damage_ppb = 0;
  bool trusted = false, storage_ok = false;
};

class PowerCut : public Image {
 protected:
  /// Boards that take turns are one, for making one takes longer than starting it.
  Restart restart(const FlashContents& flash) {
    Restart result;
    if (!probe_) {
      probe_contents_ = std::make_unique<FlashContents>();
      probe_ = std::make_unique<Board>(*probe_contents_, 7);
      probe_->most_periods = 10;
    }
    *probe_contents_ = flash;
    probe_->can.heard.clear();
    probe_->power_on();
    const bool spoke =
        probe_->run_until([&] { return !sent<protocol::LifeStatus>(*probe_).empty(); }, kSecond);
    EXPECT_TRUE(spoke);
    EXPECT_THAT(probe_->broken_rules(), IsEmpty());
    EXPECT_THAT(probe_->resets, IsEmpty());
    if (spoke) {
      const auto status = sent<protocol::LifeStatus>(*probe_).front();
      result = {status.damage_ppb, status.quality != protocol::Quality::untrusted,
                status.storage_ok};
    }
    probe_->power_off();
    return result;
  }

  /// So many saves before, of little damage.
  void save_before(std::uint32_t saves) {
    StoreMemory memory(contents);
    storage::FlashStore<StoreMemory, 1> store(memory);
    storage::LifeRecord record;
    for (std::uint32_t i = 0; i < saves; ++i) {
      lifemodel::Flags flags;
      record.epoch_damage.add({1u << 31, lifemodel::Damage::kFractionBits - 31 - 30}, 1, flags);
      record.lifetime_damage = record.epoch_damage;
      ASSERT_EQ(store.save(std::span(&record, 1)), hal::Error::none);
    }
  }

  std::unique_ptr<FlashContents> probe_contents_;
  std::unique_ptr<Board> probe_;
};

/// From `before` saves on the board saves some more. At each double word and each erase the power
/// goes on a copy: at once, within and at the end. Every restart has the life before or after.
class EveryCut : public PowerCut, public ::testing::WithParamInterface<std::uint32_t> {};

TEST_P(EveryCut, KeepsTheLife) {
  save_before(GetParam());
  Board board(contents);
  board.most_periods = 10;
  board.converters.signal = load;
  std::mt19937 random(GetParam() + 1);

  struct Cut {
    FlashContents flash;
    std::uint32_t least_ppb;
  };
  std::vector<std::unique_ptr<Cut>> cuts;
  std::uint32_t erases = 0;
  std::uint32_t words = 0;
  std::uint32_t saved_ppb = 0;
  const auto life_ppb = [&] {
    const auto life = stored_life(contents);
    return life ? life->epoch_damage.parts_per_billion() : 0;
  };
  const std::vector<double> shares = {0, 0.2, 0.5, 0.9};
  board.flash.on_begin = [&](const Flash::Operation& operation) {
    (operation.erases ? erases : words) += 1;
    saved_ppb = life_ppb();
    auto cut = std::make_unique<Cut>();
    cut->flash = contents;
    cut->least_ppb = saved_ppb;
    const double share = shares[random() % shares.size()];
    board.flash.tear_copy(cut->flash, share, random);
    cuts.push_back(std::move(cut));
  };
  board.power_on();
  std::uint32_t checked = 0;
  const auto check_all = [&] {
    const std::uint32_t after_ppb = life_ppb();
    for (const auto& cut : cuts) {
      const Restart now = restart(cut->flash);
      EXPECT_TRUE(now.damage_ppb == cut->least_ppb || now.damage_ppb == after_ppb)
          << now.damage_ppb << " ppb, neither " << cut->least_ppb << " nor " << after_ppb;
      // Without a whole record before, a torn first one cannot be told from a lost one.
      EXPECT_TRUE(now.trusted || cut->least_ppb == 0);
      EXPECT_TRUE(now.storage_ok);
      ++checked;
    }
    cuts.clear();
  };
  std::uint32_t saves = 0;
  for (int i = 0; i < 60 && saves < 4; ++i) {
    const std::uint32_t before_ppb = life_ppb();
    board.run(100 * kMillisecond);
    if (!board.flash.busy() && life_ppb() != before_ppb) {
      ++saves;
      check_all();
    }
  }
  check_all();
  EXPECT_EQ(saves, 4u);
  EXPECT_GE(words, 4 * 11u);
  EXPECT_EQ(checked, words + erases);
  EXPECT_THAT(board.broken_rules(), IsEmpty());
  EXPECT_THAT(board.resets, IsEmpty());
  std::cout << GetParam() << ": " << words << " words, " << erases << " erases\n";
}

std::vector<std::uint32_t> all_starts() {
  if (std::getenv("TENDONLIFE_ALL_POWER_CUTS") == nullptr) {
    return {0, 365};
  }
  std::vector<std::uint32_t> starts;
  // The log has 16 pages of 23 saves, and begins to erase once they are full.
  for (std::uint32_t before = 345; before < 545; before += 4) {
    starts.push_back(before);
  }
  return starts;
}
INSTANTIATE_TEST_SUITE_P(After, EveryCut, ::testing::ValuesIn(all_starts()));

/// The same board loses its power over and over, wherever it is.
TEST_F(PowerCut, TwelveInARow) {
  Board board(contents);
  board.converters.signal = load;
  std::mt19937 random(3);
  std::uint32_t damage_ppb = 0;
  for (int i = 0; i < 12; ++i) {
    board.can.heard.clear();
    board.power_on();
    const std::uint32_t least_ppb = damage_ppb;
    // While the first save is under way, a second after the start, or after it.
    int operations = static_cast<int>(random() % 16);
    board.flash.on_begin = [&](const Flash::Operation&) {
      if (operations-- == 0) {
        board.core->stop();
      }
    };
    board.run(1300 * kMillisecond);
    const auto statuses = sent<protocol::LifeStatus>(board);
    if (!statuses.empty()) {
      EXPECT_GE(statuses.front().damage_ppb, least_ppb);
    }
    board.run(random() % (85 * kMicrosecond));
    board.power_off(0.5);
    const auto life = stored_life(contents);
    damage_ppb = life ? life->epoch_damage.parts_per_billion() : 0;
    EXPECT_GE(damage_ppb, least_ppb);
  }
  EXPECT_GT(damage_ppb, 0u);
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

/// 22 ms in which nothing comes from the flash: no period is late, no sample lost, no stop missed.
TEST_F(PowerCut, NoPeriodIsLateWhileAPageIsErased) {
  save_before(365);
  Board board(contents);
  board.converters.signal = load;
  std::uint32_t erases = 0;
  Ticks opened_at = 0;
  board.core->watch_reads_of_code();
  board.flash.on_begin = [&](const Flash::Operation& operation) {
    erases += operation.erases ? 1 : 0;
    if (operation.erases && opened_at == 0 && board.drive_enabled()) {
      opened_at = board.agenda.now() + 3 * kMillisecond;
      board.agenda.at(opened_at, [&] { board.open_stop(true); });
    }
  };
  board.power_on();
  ASSERT_TRUE(board.run_until([&] { return opened_at != 0 && !board.flash.busy(); }, 8 * kSecond));
  board.run(200 * kMillisecond);
  for (std::size_t i = 1; i < board.periods.size(); ++i) {
    const Ticks between = board.periods[i].at - board.periods[i - 1].at;
    ASSERT_NEAR(static_cast<double>(between), 100.0 * kMicrosecond, 2.0 * kMicrosecond) << i;
  }
  Ticks off_at = 0;
  for (const Board::Edge& edge : board.edges) {
    off_at = edge.drive && !edge.high ? edge.at : off_at;
  }
  EXPECT_LT(off_at - opened_at, 2200 * kMicrosecond);
  EXPECT_FALSE(sent<protocol::LifeStatus>(board).back().gap);
  EXPECT_FALSE(sent<protocol::LifeStatus>(board).back().overrun);
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

}  // namespace
}  // namespace virtual_g431
