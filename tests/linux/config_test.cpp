#include "firmware/boards/linux/config.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/io/support.hpp"

namespace boards::linux_controller {
namespace {

using host_sim::test::complaint_of;

constexpr std::string_view kWhole = R"(schema = 1
[node]
id = 7
serial = "TL-0001"
authority_key = "keys/node7"
[can]
interface = "can0"
[loop]
rate_Hz = 200.0
real_time = "require"
priority = 80
[store]
folder = "/var/lib/tendonlife"
[sensor]
kind = "iio-buffer"
device = "ina226"
trigger = "trig0"
[[tendon]]
parameters = "a.block"
channel = "in_current0"
[[tendon]]
parameters = "/etc/b.block"
channel = "in_voltage1"
ampere_per_unit = -0.02
[gpio]
chip = "gpiochip0"
drive_enable = "DRIVE"
brake = { line = "4", active_low = true }
emergency_stop = { line = "STOP" }
debounce_ms = 1.5
watchdog = "WD"
)";

/// The whole configuration with one part replaced.
std::string with(std::string_view part, std::string_view other) {
  std::string text(kWhole);
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), other);
}

std::string complaint_with(std::string_view part, std::string_view other) {
  const std::string text = with(part, other);
  return complaint_of([&] { parse_config(text, "c.toml"); });
}

/// The second tendon with these lines behind it.
std::string with_covariates(std::string_view lines) {
  return with("ampere_per_unit = -0.02\n",
              std::string("ampere_per_unit = -0.02\n") + std::string(lines));
}

TEST(Config, NamesWhatAnExtendedModelNeeds) {
  const Config config = parse_config(
      with_covariates(
          "tendon_velocity_m_s = { device = \"encoder\", channel = \"in_anglvel0\", "
          "per_unit = 0.0125 }\n"
          "motor_angle_rad = { device = \"encoder\", channel = \"in_angl0\" }\n"
          "sheath_temperature_C = { can_id = 0x1A0, start_bit = 8, bits = 16, signed = "
          "true, factor = 0.1, zero = -40, timeout_ms = 500 }\n"
          "winding_temperature_C = { device = \"iio:device2\", channel = \"in_temp1\" }\n"),
      "c.toml");
  for (const auto& none : config.tendons[0].covariates) {
    EXPECT_FALSE(none.has_value());
  }
  const auto& covariates = config.tendons[1].covariates;
  const auto& velocity = std::get<IioQuantity>(*covariates[0]);
  EXPECT_EQ(velocity.device, "encoder");
  EXPECT_EQ(velocity.channel, "in_anglvel0");
  EXPECT_EQ(velocity.per_unit, 0.0125);
  EXPECT_EQ(std::get<IioQuantity>(*covariates[1]).per_unit, 1);
  const auto& sheath = std::get<BusQuantity>(*covariates[2]);
  EXPECT_EQ(sheath.id, 0x1a0u);
  EXPECT_FALSE(sheath.extended);
  EXPECT_EQ(sheath.start_bit, 8u);
  EXPECT_EQ(sheath.bits, 16u);
  EXPECT_TRUE(sheath.is_signed);
  EXPECT_EQ(sheath.factor, 0.1);
  EXPECT_EQ(sheath.zero, -40);
  EXPECT_EQ(sheath.timeout_ms, 500u);
  EXPECT_EQ(std::get<IioQuantity>(*covariates[3]).per_unit, 1e-3);
}

TEST(Config, RefusesWhatIsNoQuantity) {
  const auto complaint = [](std::string_view lines) {
    const std::string text = with_covariates(lines);
    return complaint_of([&] { parse_config(text, "c.toml"); });
  };
  EXPECT_NE(complaint("tendon_velocity_m_s = { device = \"e\", channel = \"in_anglvel0\" }\n")
                .find("per_unit"),
            std::string::npos);
  EXPECT_NE(complaint("motor_angle_rad = { channel = \"in_angl0\" }\n").find("device"),
            std::string::npos);
  EXPECT_NE(
      complaint("motor_angle_rad = { can_id = 0x800, start_bit = 0, bits = 8, timeout_ms = 9 }\n")
          .find("accepted: can_id 0..2047"),
      std::string::npos);
  EXPECT_NE(
      complaint("motor_angle_rad = { can_id = 1, start_bit = 60, bits = 8, timeout_ms = 9 }\n")
          .find("bits is 8; accepted: bits 1..4"),
      std::string::npos);
  EXPECT_NE(
      complaint("motor_angle_rad = { can_id = 1, start_bit = 0, bits = 8 }\n").find("timeout_ms"),
      std::string::npos);
}

TEST(Config, TakesEverythingFromTheFile) {
  const Config config = parse_config(kWhole, "c.toml", "/etc/tl");
  EXPECT_EQ(config.node, 7);
  EXPECT_EQ(config.serial, "TL-0001");
  EXPECT_EQ(config.authority_key, "/etc/tl/keys/node7");
  EXPECT_EQ(config.can.interface, "can0");
  EXPECT_EQ(config.loop.period_us, 5'000U);
  EXPECT_EQ(config.loop.real_time, RealTime::require);
  EXPECT_EQ(config.loop.priority, 80);
  EXPECT_EQ(config.store, "/var/lib/tendonlife");
  EXPECT_EQ(config.sensor.kind, SensorKind::iio_buffer);
  EXPECT_EQ(config.sensor.device, "ina226");
  EXPECT_EQ(config.sensor.trigger, "trig0");
  ASSERT_EQ(config.tendons.size(), 2U);
  EXPECT_EQ(config.tendons[0].parameters, "/etc/tl/a.block");
  EXPECT_EQ(config.tendons[0].channel, "in_current0");
  EXPECT_EQ(config.tendons[0].ampere_per_unit, 1e-3);
  EXPECT_EQ(config.tendons[1].parameters, "/etc/b.block");
  EXPECT_EQ(config.tendons[1].ampere_per_unit, -0.02);
  ASSERT_TRUE(config.gpio);
  EXPECT_EQ(config.gpio->chip, "gpiochip0");
  EXPECT_EQ(config.gpio->drive_enable.line, "DRIVE");
  EXPECT_FALSE(config.gpio->drive_enable.active_low);
  EXPECT_EQ(config.gpio->brake.line, "4");
  EXPECT_TRUE(config.gpio->brake.active_low);
  EXPECT_FALSE(config.gpio->emergency_stop.active_low);
  EXPECT_EQ(config.gpio->debounce, std::chrono::microseconds(1'500));
  EXPECT_FALSE(config.gpio->status_light);
  EXPECT_EQ(config.gpio->watchdog->line, "WD");
}

TEST(Config, HasDefaults) {
  const Config config =
      parse_config(with("real_time = \"require\"\npriority = 80\n", ""), "c.toml");
  EXPECT_EQ(config.loop.real_time, RealTime::prefer);
  EXPECT_EQ(config.loop.priority, 50);
  EXPECT_EQ(parse_config(with("debounce_ms = 1.5\n", ""), "c.toml").gpio->debounce,
            std::chrono::microseconds(2'000));
}

TEST(Config, ABenchHasNoBusNoLinesAndAProfile) {
  const Config config = parse_config(R"(schema = 1
[node]
id = 127
[can]
interface = "none"
log = "frames.log"
[loop]
rate_Hz = 1000
[store]
folder = "store"
[sensor]
kind = "profile"
at_end = "repeat"
[[tendon]]
parameters = "a.block"
profile = "p.csv"
[gpio]
chip = "none"
)",
                                     "c.toml", "bench");
  EXPECT_EQ(config.can.log, "bench/frames.log");
  EXPECT_EQ(config.sensor.at_end, AtEnd::repeat);
  EXPECT_EQ(config.tendons[0].profile, "bench/p.csv");
  EXPECT_FALSE(config.gpio);
  EXPECT_FALSE(config.authority_key);
}

TEST(Config, TheExampleIsRead) {
  const Config config = read_config(TENDONLIFE_EXAMPLE_CONFIG);
  EXPECT_EQ(config.node, 1);
  EXPECT_EQ(config.can.interface, "can0");
  EXPECT_EQ(config.sensor.kind, SensorKind::iio_buffer);
  EXPECT_TRUE(config.gpio->emergency_stop.active_low);
}

struct BadConfig {
  std::string_view part;
  std::string_view other;
  std::string_view complaint;
};

class Refused : public testing::TestWithParam<BadConfig> {};

TEST_P(Refused, IsToldWithPlaceAndWhatIsAccepted) {
  EXPECT_EQ(complaint_with(GetParam().part, GetParam().other), GetParam().complaint);
}

constexpr BadConfig kBad[]{
    {"schema = 1", "schema = 2", "c.toml:1:1: schema is 2; accepted: schema 1..1, a whole number"},
    {"schema = 1", "", "c.toml:1:1: no key schema; accepted: schema 1..1, a whole number"},
    {"id = 7", "id = 128", "c.toml:3:1: id is 128; accepted: id 1..127, a whole number"},
    {"id = 7", "id = 1.5", "c.toml:3:1: id is 1.5; accepted: id 1..127, a whole number"},
    {"id = 7", "nodeid = 7",
     "c.toml:3:1: unknown key 'nodeid' in [node]; accepted: id, serial, authority_key"},
    {"TL-0001", "TL-0001-0002-3",
     "c.toml:4:1: serial is 'TL-0001-0002-3'; accepted: serial of 1 to 12 characters"},
    {"[can]\ninterface = \"can0\"\n", "", "c.toml:1:1: no table [can]; accepted: a table [can]"},
    {"interface = \"can0\"", "interface = 0",
     "c.toml:7:1: interface is 0; accepted: the name of a CAN interface, or \"none\""},
    {"interface = \"can0\"", "interface = \"can0\"\nlog = \"x\"",
     "c.toml:8:1: a log beside a bus; accepted: log where interface is \"none\"; candump logs a "
     "bus"},
    {"rate_Hz = 200.0", "rate_Hz = 0", "c.toml:9:1: rate_Hz is 0; accepted: rate_Hz 1..20000"},
    {"rate_Hz = 200.0", "rate_Hz = nan", "c.toml:9:1: rate_Hz is nan; accepted: rate_Hz 1..20000"},
    {"\"require\"", "\"always\"",
     "c.toml:10:1: real_time is 'always'; accepted: real_time \"off\", \"prefer\", \"require\""},
    {"priority = 80", "priority = 99",
     "c.toml:11:1: priority is 99; accepted: priority 1..98, a whole number"},
    {"\"/var/lib/tendonlife\"", "\"\"",
     "c.toml:13:1: folder is ''; accepted: a folder to keep the lives in"},
    {"iio-buffer", "adc",
     "c.toml:15:1: kind is 'adc'; accepted: kind \"iio\", \"iio-buffer\", \"profile\""},
    {"iio-buffer", "iio",
     "c.toml:17:1: trigger is of no use here; accepted: trigger where kind is \"iio-buffer\""},
    {"channel = \"in_current0\"", "channel = \"../x\"",
     "c.toml:20:1: channel is '../x'; accepted: a channel of the IIO device, e.g. \"in_current0\""},
    {"channel = \"in_current0\"", "profile = \"p.csv\"",
     "c.toml:20:1: profile is of no use here; accepted: profile where the sensor is a profile"},
    {"channel = \"in_current0\"\n", "",
     "c.toml:18:1: no key channel in [[tendon]]; accepted: a channel of the IIO device, e.g. "
     "\"in_current0\""},
    {"chip = \"gpiochip0\"", "chip = \"none\"",
     "c.toml:27:1: drive_enable is of no use here; accepted: drive_enable where chip is not "
     "\"none\""},
    {"drive_enable = \"DRIVE\"", "drive_enable = 3",
     "c.toml:27:1: drive_enable is 3; accepted: the name or offset of a line as a text, or { line "
     "= \"...\", active_low = true }"},
    {"emergency_stop = { line = \"STOP\" }\n", "",
     "c.toml:25:2: no key emergency_stop in [gpio]; accepted: the name or offset of a line as a "
     "text, or { line = \"...\", active_low = true }"},
    {"active_low = true", "active_low = 1",
     "c.toml:28:23: active_low is 1; accepted: true or false"},
    {"active_low = true", "low = true",
     "c.toml:28:23: unknown key 'low' in [gpio.brake]; accepted: line, active_low"},
    {"debounce_ms = 1.5", "debounce_ms = 20",
     "c.toml:30:1: debounce_ms is 20; accepted: debounce_ms 1..5"},
    {"[store]", "[stores]",
     "c.toml:12:2: unknown table 'stores'; accepted: schema, node, can, loop, store, sensor, "
     "tendon, gpio"},
};
INSTANTIATE_TEST_SUITE_P(Config, Refused, testing::ValuesIn(kBad));

TEST(Config, AFileThatIsNoTomlIsRefusedWithItsPlace) {
  const std::string complaint = complaint_with("id = 7", "id = ");
  EXPECT_TRUE(complaint.starts_with("c.toml:3:")) << complaint;
  EXPECT_TRUE(complaint.ends_with("; accepted: TOML 1.0")) << complaint;
}

TEST(Config, AFileThatIsTooDeepIsRefusedBeforeItIsParsed) {
  std::string table = "[a";
  for (int i = 0; i < 31'000; ++i) {
    table += ".a";
  }
  EXPECT_EQ(complaint_with("[can]", table + "]"),
            "c.toml:6:65: more than 32 levels; accepted: TOML of at most 32 levels");
}

TEST(Config, ThereAreOneToFourTendons) {
  std::string five(kWhole);
  for (int i = 0; i < 3; ++i) {
    five += "[[tendon]]\nparameters = \"a\"\nchannel = \"in_current0\"\n";
  }
  EXPECT_EQ(complaint_of([&] { parse_config(five, "c.toml"); }),
            "c.toml:18:3: tendon has 5 entries; accepted: 1 to 4 tables [[tendon]]");
}

TEST(Config, AMissingFileIsNamed) {
  const std::string complaint = complaint_of([] { read_config("/no/such.toml"); });
  EXPECT_TRUE(complaint.starts_with("/no/such.toml: ")) << complaint;
  EXPECT_NE(complaint.find("a configuration (TOML) of at most 1 MiB"), std::string::npos);
}

}  // namespace
}  // namespace boards::linux_controller
