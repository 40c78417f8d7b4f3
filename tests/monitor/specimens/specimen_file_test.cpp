#include "host_sim/monitor/specimens/specimen_file.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <optional>
#include <sstream>

#include "hal/files/input_error.hpp"
#include "hal/files/output_file.hpp"

namespace host_sim::monitor {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHead =
    "specimen,lot,input_tension_mean_N,input_tension_amplitude_N,cycles,status\n";

class SpecimenFileTest : public testing::Test {
 protected:
  void SetUp() override { fs::remove(path_); }
  void TearDown() override { fs::remove(path_); }

  [[nodiscard]] std::string text() const {
    std::ifstream in(path_);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
  }
  void put(const std::string& text) const { std::ofstream(path_) << text; }

  fs::path path_ = fs::path(testing::TempDir()) /
                   (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) +
                    "_specimens.csv");
  Model::Life life_{.mean_stress = Model::MeanStress::kGerber,
                    .ipl_scale = 1e6,
                    .ipl_exponent = 2,
                    .weibull_shape = 5.94};
};

constexpr std::uint32_t kModel = 0x12345678;
/// CRC-32 of the little-endian words 0 and kModel (by zlib), which a node of one tendon reports;
/// with that word and kModel again it is of two tendons.
constexpr std::uint32_t kOneTendon = 0xeb0b87a7;
constexpr std::uint32_t kTwoTendons = 0x33f1bb43;

FleetView fleet_with(const WireLife& life,
                     std::optional<std::uint32_t> configuration = kTwoTendons) {
  FleetView view;
  view.nodes[3].node = 3;
  if (configuration) {
    view.nodes[3].identity.emplace().value.configuration = *configuration;
  }
  view.nodes[3].wire_lives = {life};
  return view;
}

/// 1e6 / T^2 cycles at T: 40 N last 625, and after 500 the damage is 0.8.
WireLife broken_at_40_N() {
  return {.tendon = 1,
          .broken = true,
          .time_ns = 1'600'000'000'123'000'000,
          .damage_ppb = 800'000'000,
          .cycles = 500};
}

TEST_F(SpecimenFileTest, HasTheTensionThatDoesTheDamage) {
  const std::string first =
      kHead + std::string("node3-tendon1-1600000000.123,field,0,40,500,failed\n");
  {
    SpecimenFile file(path_, life_, kModel);
    EXPECT_FALSE(fs::exists(path_));
    file.update({});
    EXPECT_EQ(text(), kHead);
    file.update(fleet_with(broken_at_40_N()));
    EXPECT_EQ(text(), first);
    EXPECT_EQ(file.trouble(), "");
  }
  SpecimenFile again(path_, life_, kModel);
  again.update(fleet_with(broken_at_40_N()));
  again.update(fleet_with({.tendon = 0,
                           .broken = false,
                           .time_ns = 1'600'000'009'000'000'000,
                           .damage_ppb = 500'000'000,
                           .cycles = 1250}));
  EXPECT_EQ(text(), first + "node3-tendon0-1600000009.000,field,0,20,1250,suspended\n");
}

TEST_F(SpecimenFileTest, WritesNothingOfALifeThatIsNotKnown) {
  SpecimenFile file(path_, life_, kModel);
  WireLife life = broken_at_40_N();
  life.cycles.reset();
  file.update(fleet_with(life));
  EXPECT_EQ(text(), kHead);
  EXPECT_EQ(file.trouble(), path_.string() +
                                ": node3-tendon1-1600000000.123 broke, and its cycles or damage "
                                "are not known: no row");
  life.cycles = 500;
  for (const std::uint32_t unknown : {0U, 0xffffffffU}) {
    life.damage_ppb = unknown;
    file.update(fleet_with(life));
    EXPECT_EQ(text(), kHead);
  }
  file.update(fleet_with(broken_at_40_N()));
  EXPECT_EQ(file.trouble(), "");
  EXPECT_NE(text(), kHead);
}

TEST_F(SpecimenFileTest, WritesNothingOfANodeWithOtherParameters) {
  SpecimenFile file(path_, life_, kModel);
  file.update(fleet_with(broken_at_40_N(), 0x1234abcd));
  EXPECT_EQ(text(), kHead);
  EXPECT_EQ(file.trouble(), path_.string() +
                                ": node 3 counts with other parameters than the model "
                                "(configuration 1234abcd): no rows of it");
  file.update(fleet_with(broken_at_40_N(), std::nullopt));
  EXPECT_EQ(text(), kHead);
  EXPECT_EQ(file.trouble(), path_.string() +
                                ": node3-tendon1-1600000000.123 broke, and node 3 has not "
                                "reported which parameters it counts with: no row");
  file.update(fleet_with(broken_at_40_N(), kOneTendon));
  EXPECT_NE(text(), kHead);
  EXPECT_EQ(file.trouble(), "");
}

TEST_F(SpecimenFileTest, LeavesOtherFilesAlone) {
  const std::string other = "specimen,cycles\na,1\n";
  put(other);
  EXPECT_THROW(SpecimenFile(path_, life_, kModel), hal::files::InputError);
  EXPECT_EQ(text(), other);
  put(kHead + std::string("node1-tendon0-1"));
  EXPECT_THROW(SpecimenFile(path_, life_, kModel), hal::files::InputError);
  const fs::path folder = testing::TempDir();
  EXPECT_THROW(SpecimenFile(folder / "none" / "s.csv", life_, kModel), hal::files::OutputError);
  EXPECT_THROW(SpecimenFile(folder, life_, kModel), hal::files::OutputError);
  EXPECT_THROW(SpecimenFile("-", life_, kModel), hal::files::OutputError);
}

}  // namespace
}  // namespace host_sim::monitor
