#include "firmware/boards/linux/setup.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>

#include "firmware/boards/linux/sensors.hpp"
#include "lifemodel/pack/pack.hpp"
#include "tests/io/support.hpp"

namespace boards::linux_controller {
namespace {

namespace fs = std::filesystem;
using host_sim::test::complaint_of;
using host_sim::test::TemporaryFolder;
using host_sim::test::write_text;
using lifemodel::extension::DriveSample;

class KeyFile : public testing::Test {
 protected:
  void put(std::string_view text, unsigned mode = 0600) {
    write_text(path_, text);
    fs::permissions(path_, static_cast<fs::perms>(mode));
  }
  std::string complaint() {
    return complaint_of([&] { static_cast<void>(read_authority_key(path_)); });
  }

  TemporaryFolder folder_;
  fs::path path_ = folder_ / "key";
};

TEST_F(KeyFile, IsReadFromHexadecimalDigits) {
  put("2b7e151628aed2a6ABF7158809CF4F3C\n");
  const app::Key key = read_authority_key(path_);
  EXPECT_EQ(key[0], std::byte{0x2b});
  EXPECT_EQ(key[7], std::byte{0xa6});
  EXPECT_EQ(key[8], std::byte{0xab});
  EXPECT_EQ(key[15], std::byte{0x3c});
}

TEST_F(KeyFile, ThatOthersMayUseIsRefused) {
  for (const unsigned mode : {0640U, 0604U, 0620U, 0601U, 0777U}) {
    put("2b7e151628aed2a6abf7158809cf4f3c\n", mode);
    EXPECT_NE(complaint().find("others may use it"), std::string::npos) << mode;
  }
  put("2b7e151628aed2a6abf7158809cf4f3c\n", 0400);
  EXPECT_EQ(complaint(), "");
}

TEST_F(KeyFile, ThatIsNoKeyIsRefusedWithoutBeingTold) {
  for (const char* text :
       {"", "2b7e", "2b7e151628aed2a6abf7158809cf4f3", "2b7e151628aed2a6abf7158809cf4f3g",
        "2b7e151628aed2a6abf7158809cf4f3c00", "0x2b7e151628aed2a6abf7158809cf4f",
        "-b7e151628aed2a6abf7158809cf4f3c"}) {
    put(text);
    EXPECT_NE(complaint().find("not 32 hexadecimal digits; accepted: 32 hexadecimal digits"),
              std::string::npos)
        << text;
    EXPECT_EQ(complaint().find("2b7e"), std::string::npos);
  }
}

TEST_F(KeyFile, OfZerosIsRefused) {
  put("00000000000000000000000000000000\n");
  EXPECT_NE(complaint().find("a key of zeros"), std::string::npos);
}

TEST_F(KeyFile, ThatIsMissingOrAFolderIsRefused) {
  EXPECT_NE(complaint().find("key: "), std::string::npos);
  fs::create_directory(path_);
  EXPECT_NE(complaint().find("not a regular file"), std::string::npos);
}

lifemodel::pack::Constants constants() {
  lifemodel::pack::Constants c;
  c.ultimate_tension_N = 200;
  c.hysteresis_N = 0.2;
  c.ipl_scale = 1.53e5;
  c.ipl_exponent = 1.38;
  c.weibull_shape = 5.94;
  c.bend_angle_rad = 1;
  c.tension_per_current_N_A = 20;
  c.sample_period_s = 0.001;
  return c;
}

lifemodel::Parameters parameters() {
  return *lifemodel::pack::parameters(constants());
}

class BlockFile : public testing::Test {
 protected:
  void put(const lifemodel::ParameterBlock& block, std::size_t bytes = lifemodel::kBlockBytes) {
    write_text(path_, std::string_view(reinterpret_cast<const char*>(block.data()), bytes));
  }
  std::string complaint(std::uint32_t period_us = 1'000) {
    return complaint_of([&] { static_cast<void>(read_model(path_, period_us)); });
  }

  TemporaryFolder folder_;
  fs::path path_ = folder_ / "block";
};

TEST_F(BlockFile, IsReadAndChecked) {
  lifemodel::ParameterBlock block = lifemodel::encode(parameters());
  put(block);
  EXPECT_EQ(read_model(path_, 1'000).nominal.ultimate_mN, 200'000U);

  block[40] ^= std::byte{1};
  put(block);
  EXPECT_NE(complaint().find("damaged: the CRC-32 does not fit"), std::string::npos);
  put(block, 83);
  EXPECT_NE(complaint().find("wrong size"), std::string::npos);
  write_text(path_, std::string(617, 'x'));
  EXPECT_NE(complaint().find("larger than 616 bytes"), std::string::npos);
}

TEST_F(BlockFile, MayHaveAnExtension) {
  lifemodel::ExtendedParameters model{parameters(), {}};
  model.extension.current_offset.offset = 1 << 20;
  model.extension.add(lifemodel::extension::Effect::current_offset);
  std::array<std::byte, lifemodel::kMostExtendedBytes> bytes{};
  const std::size_t size = lifemodel::encode(model, bytes).size();
  const auto put_whole = [&] {
    write_text(path_, std::string_view(reinterpret_cast<const char*>(bytes.data()), size));
  };
  put_whole();
  EXPECT_EQ(read_model(path_, 1'000).extension.current_offset.offset, 1 << 20);
  bytes[90] ^= std::byte{1};
  put_whole();
  EXPECT_NE(complaint().find("extension "), std::string::npos);
}

TEST_F(BlockFile, OfAnotherSamplePeriodIsRefused) {
  put(lifemodel::encode(parameters()));
  EXPECT_NE(complaint(500).find("made for a sample every 1000 us, and the loop has 500 us"),
            std::string::npos);
}

class Profiles : public testing::Test {
 protected:
  fs::path put(std::string_view name, std::string_view text) {
    write_text(folder_ / name, text);
    return folder_ / name;
  }

  TemporaryFolder folder_;
};

TEST_F(Profiles, RowsThatAreMissingAreHoles) {
  const auto path =
      put("p.csv", "time_s,motor_current_A\n5.000,1\n5.001,2\n5.00405,-3\n5.005,200\n5.006,5\n");
  const auto recorded = read_samples<DriveSample>(path, parameters());
  EXPECT_EQ(recorded.holes, (std::vector<bool>{false, false, true, true, false, true, false}))
      << "and 200 A is no MotorCurrent";
  EXPECT_EQ(recorded.samples[1].current.raw(), 2 << 24);
  EXPECT_EQ(recorded.samples[4].current.raw(), -3 * (1 << 24));
}

TEST_F(Profiles, OfAnotherRateAreRefused) {
  const auto path = put("p.csv", "time_s,motor_current_A\n0,1\n0.0005,2\n");
  EXPECT_NE(complaint_of([&] {
              read_samples<DriveSample>(path, parameters());
            }).find("rows at 0 s and 0.0005 s, which are 0.5 periods of 1000 us apart"),
            std::string::npos);
}

TEST_F(Profiles, TensionIsRelativeToTheUltimateTension) {
  const auto path = put("p.csv", "time_s,input_tension_N\n0,100\n0.001,-50\n0.002,900\n");
  const auto recorded = read_samples<lifemodel::Tension>(path, parameters());
  EXPECT_EQ(recorded.samples[0].raw(), 1 << 28);
  EXPECT_EQ(recorded.samples[1].raw(), -(1 << 27));
  EXPECT_TRUE(recorded.holes[2]) << "900 N is 4.5 of the ultimate tension";
}

TEST_F(Profiles, OutputTensionKeepsItsDirectionWhileStanding) {
  using lifemodel::Direction;
  const auto path = put("p.csv",
                        "time_s,output_tension_N,tendon_velocity_m_s,bend_angle_deg\n"
                        "0,100,0,180\n0.001,100,-1,90\n0.002,100,0,90\n0.003,100,2,90\n");
  const auto recorded = read_samples<app::OutputTension>(path, parameters());
  EXPECT_EQ(recorded.samples[0].direction, Direction::pulling);
  EXPECT_EQ(recorded.samples[1].direction, Direction::releasing);
  EXPECT_EQ(recorded.samples[2].direction, Direction::releasing);
  EXPECT_EQ(recorded.samples[3].direction, Direction::pulling);
  // pi * 2^26 = 210828714.1
  EXPECT_EQ(recorded.samples[0].bend.raw(), 210'828'714);

  const auto straight = put("q.csv", "time_s,output_tension_N,tendon_velocity_m_s\n0,100,0\n");
  EXPECT_EQ(read_samples<app::OutputTension>(straight, parameters()).samples[0].bend.raw(), 1 << 26)
      << "the bend of the model";
}

TEST_F(Profiles, HaveWhatAnExtendedModelIsWrittenInTermsOf) {
  const auto path = put("p.csv",
                        "time_s,motor_current_A,tendon_velocity_m_s,motor_angle_rad,"
                        "winding_temperature_C\n0,2,-0.5,3.141592653589793,-40.5\n");
  const auto recorded = read_samples<DriveSample>(path, parameters()).samples.at(0);
  EXPECT_EQ(recorded.current.raw(), 2 << 24);
  EXPECT_EQ(recorded.at.velocity.raw(), -(1 << 23));
  EXPECT_EQ(recorded.at.rotor.raw, std::int64_t{1} << 31);  // half a turn
  EXPECT_EQ(recorded.at.winding.raw(), -81 * (1 << 15));
  EXPECT_EQ(recorded.at.sheath.raw(), 0);

  const auto force = put("q.csv", "time_s,output_tension_N,tendon_velocity_m_s\n0,-100,0.25\n");
  const auto pair =
      read_samples<lifemodel::extension::SheathSample>(force, parameters()).samples.at(0);
  EXPECT_EQ(pair.tension.raw(), -(1 << 28));
  EXPECT_EQ(pair.at.velocity.raw(), 1 << 22);
  EXPECT_EQ(pair.bend.raw(), 1 << 26);
}

TEST_F(Profiles, OfSeveralTendonsAreOfOneKind) {
  const std::array same{put("a.csv", "time_s,motor_current_A\n0,1\n"),
                        put("b.csv", "time_s,motor_current_A\n0,1\n")};
  EXPECT_EQ(kind_of(same), hal::files::InputKind::kMotorCurrent);
  const std::array mixed{same[0], put("c.csv", "time_s,input_tension_N\n0,1\n")};
  EXPECT_NE(complaint_of([&] {
              static_cast<void>(kind_of(mixed));
            }).find("profiles of one kind for all tendons"),
            std::string::npos);
}

TEST_F(Profiles, ArePlayedOnceOrAgainAndAgain) {
  const auto path = put("p.csv", "time_s,motor_current_A\n0,1\n0.002,2\n");
  const auto recorded = read_samples<DriveSample>(path, parameters());
  ProfileSensor<DriveSample> once({recorded}, false);
  EXPECT_EQ((*once.isr_read(0)).current.raw(), 1 << 24);
  EXPECT_EQ(once.isr_read(0).error(), hal::Error::missing);
  EXPECT_FALSE(once.at_end());
  EXPECT_EQ((*once.isr_read(0)).current.raw(), 2 << 24);
  EXPECT_TRUE(once.at_end());
  EXPECT_EQ(once.isr_read(0).error(), hal::Error::missing);
  EXPECT_EQ(once.isr_read(1).error(), hal::Error::out_of_range);

  ProfileSensor<DriveSample> again({recorded}, true);
  for (int i = 0; i < 3; ++i) {
    static_cast<void>(again.isr_read(0));
  }
  EXPECT_FALSE(again.at_end());
  EXPECT_EQ((*again.isr_read(0)).current.raw(), 1 << 24);
}

}  // namespace
}  // namespace boards::linux_controller
