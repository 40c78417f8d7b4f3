// Scans and attributes as Documentation/ABI/testing/sysfs-bus-iio and
// Documentation/driver-api/iio/buffers.rst describe them, in a folder that stands for /sys.

#include "hal/linux/iio.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "hal/linux/device_error.hpp"
#include "lifemodel/pack/pack.hpp"
#include "tests/io/support.hpp"

namespace hal::linux_os {
namespace {

namespace fs = std::filesystem;
using lifemodel::MotorCurrent;

TEST(IioType, ReadsTheFormsOfTheKernel) {
  EXPECT_EQ(parse_iio_type("le:s12/16>>4"), (IioType{false, true, 12, 2, 4}));
  EXPECT_EQ(parse_iio_type("be:u16/32>>8"), (IioType{true, false, 16, 4, 8}));
  EXPECT_EQ(parse_iio_type("le:s64/64>>0"), (IioType{false, true, 64, 8, 0}));
  EXPECT_EQ(parse_iio_type("le:u8/8"), (IioType{false, false, 8, 1, 0}));
}

TEST(IioType, RefusesAllElse) {
  for (const char* text :
       {"", "le", "le:", "xe:s12/16>>4", "le:x12/16>>4", "le:s0/16>>0", "le:s17/16>>0",
        "le:s12/12>>0", "le:s12/16>>5", "le:s12/16>>16", "le:s12/16X2>>4", "le:s12/16>>4 ",
        "le:s12/16>>", "le:s-1/16>>0", "le:u64/64>>0", "le:s12/128>>0", "le:s4294967297/16>>0"}) {
    EXPECT_FALSE(parse_iio_type(text)) << text;
  }
}

template <std::size_t n>
std::int64_t value(std::string_view type, const std::array<unsigned, n>& bytes) {
  std::array<std::byte, n> element{};
  for (std::size_t i = 0; i < n; ++i) {
    element[i] = static_cast<std::byte>(bytes[i]);
  }
  return iio_value(*parse_iio_type(type), element);
}

TEST(IioType, TakesTheBitsOutOfAnElement) {
  // 0xfff0 >> 4 = 0xfff, -1 of 12 bits.
  EXPECT_EQ(value("le:s12/16>>4", std::array{0xf0U, 0xffU}), -1);
  EXPECT_EQ(value("le:u12/16>>4", std::array{0xf0U, 0xffU}), 4'095);
  // 0x8001 >> 4 = 0x800, the lowest of 12 bits.
  EXPECT_EQ(value("be:s12/16>>4", std::array{0x80U, 0x01U}), -2'048);
  EXPECT_EQ(value("be:u16/32>>8", std::array{0xffU, 0x12U, 0x34U, 0xffU}), 0x1234);
  EXPECT_EQ(
      value("le:s64/64>>0", std::array{0xfeU, 0xffU, 0xffU, 0xffU, 0xffU, 0xffU, 0xffU, 0xffU}),
      -2);
  EXPECT_EQ(value("le:u8/8", std::array{0x80U}), 128);
}

/// A device in a folder of its own.
class IioDevice : public testing::Test {
 protected:
  IioDevice() : device_(folder_ / "sys/bus/iio/devices/iio:device3") {
    fs::create_directories(device_ / "scan_elements");
    fs::create_directories(device_ / "buffer");
    fs::create_directories(device_ / "trigger");
    fs::create_directories(folder_ / "dev");
    put("name", "ina226");
    put("in_current0_raw", "1000");
    put("in_current0_scale", "2.5");
    put("in_current0_offset", "-200");
    put("in_current1_raw", "-3");
    put("in_current_scale", "0.5");
    put("in_voltage2_raw", "7");
    put("in_voltage2_scale", "1e10");
    for (const char* attribute : {"buffer/enable", "buffer/length", "trigger/current_trigger"}) {
      put(attribute, "");
    }
    element("in_current0", 2, "le:s16/16>>0");
    element("in_current1", 0, "be:s24/32>>8");
    element("in_timestamp", 3, "le:s64/64>>0");
    put("scan_elements/in_timestamp_en", "1");
  }

  void put(const std::string& attribute, const std::string& text) const {
    std::ofstream(device_ / attribute) << text << '\n';
  }
  void element(const std::string& channel, int index, const std::string& type) const {
    put("scan_elements/" + channel + "_en", "0");
    put("scan_elements/" + channel + "_index", std::to_string(index));
    put("scan_elements/" + channel + "_type", type);
  }
  [[nodiscard]] std::string get(const std::string& attribute) const {
    return read_attribute(device_ / attribute).value_or("?");
  }
  [[nodiscard]] fs::path sys() const { return folder_ / "sys"; }
  [[nodiscard]] fs::path dev() const { return folder_ / "dev"; }

  template <class Act>
  static std::string complaint_of(Act act) {
    try {
      act();
    } catch (const DeviceError& error) {
      return error.what();
    }
    return {};
  }

  host_sim::test::TemporaryFolder folder_;
  fs::path device_;
  std::array<IioChannelSpec, 2> channels_{IioChannelSpec{"in_current0", 1e-3},
                                          IioChannelSpec{"in_current1", 1e-3}};
};

double ampere(const Result<MotorCurrent>& result) {
  EXPECT_TRUE(result);
  return result ? lifemodel::pack::to_double(*result) : -999;
}

TEST_F(IioDevice, ReadsCurrentFromSysfs) {
  IioSysfs sensor("ina226", channels_, sys());
  // (1000 - 200) * 2.5 mA, and -3 * 0.5 mA with the scale of the type and no offset.
  EXPECT_NEAR(ampere(sensor.isr_read(0)), 2.0, 1e-7);
  EXPECT_NEAR(ampere(sensor.isr_read(1)), -0.0015, 1e-7);
  put("in_current0_raw", "600");
  EXPECT_NEAR(ampere(sensor.isr_read(0)), 1.0, 1e-7) << "each read is a new sample";
}

TEST_F(IioDevice, TellsWhatCannotBeRead) {
  const std::array specs{IioChannelSpec{"in_current0", 1e-3}, IioChannelSpec{"in_voltage2", 1.0}};
  IioSysfs sensor("iio:device3", specs, sys());
  EXPECT_EQ(sensor.isr_read(2).error(), Error::out_of_range);
  EXPECT_EQ(sensor.isr_read(1).error(), Error::failed) << "7e10 A";
  put("in_current0_raw", "ten");
  EXPECT_EQ(sensor.isr_read(0).error(), Error::failed);
  std::ofstream(device_ / "in_current0_raw", std::ios::trunc).close();
  EXPECT_EQ(sensor.isr_read(0).error(), Error::failed);
}

TEST_F(IioDevice, AMissingDeviceIsNamedWithThoseThatAreThere) {
  EXPECT_EQ(complaint_of([&] { IioSysfs("ina219", channels_, sys()); }),
            "ina219: no such IIO device; accepted: name of an IIO device; there are: "
            "iio:device3 (ina226)");
  EXPECT_EQ(complaint_of([&] { IioSysfs("x", channels_, dev()); }),
            "x: no such IIO device; accepted: name of an IIO device; there are: none");
}

TEST_F(IioDevice, AMissingChannelOrScaleIsNamed) {
  const std::array missing{IioChannelSpec{"in_current9", 1e-3}};
  EXPECT_NE(complaint_of([&] {
              IioSysfs("ina226", missing, sys());
            }).find("in_current9_raw: No such file or directory"),
            std::string::npos);
  put("in_current0_scale", "0");
  EXPECT_NE(complaint_of([&] { IioSysfs("ina226", channels_, sys()); }).find("scale is 0"),
            std::string::npos);
  put("in_current0_scale", "2.5");
  put("in_current0_offset", "some");
  EXPECT_NE(complaint_of([&] { IioSysfs("ina226", channels_, sys()); }).find("offset is some"),
            std::string::npos);
}

/// The character device is a pipe, which reads as one does: what is there, without waiting.
class IioScans : public IioDevice {
 protected:
  IioScans() {
    const fs::path path = dev() / "iio:device3";
    EXPECT_EQ(::mkfifo(path.c_str(), 0600), 0);
    pipe_ = ::open(path.c_str(), O_RDWR | O_NONBLOCK);
  }
  ~IioScans() override { ::close(pipe_); }

  // Elements in the order of their index: 4 bytes of in_current1, 2 of in_current0, and 2 more to a
  // multiple of the largest.
  void scan(std::int16_t current0, std::uint8_t current1) const {
    const auto low = static_cast<std::uint8_t>(current0 & 0xff);
    const auto high = static_cast<std::uint8_t>((current0 >> 8) & 0xff);
    const std::array<std::uint8_t, 8> bytes{0, 0, current1, 0x5a, low, high, 0xa5, 0xa5};
    ASSERT_EQ(::write(pipe_, bytes.data(), bytes.size()), 8);
  }

  int pipe_ = -1;
};

TEST_F(IioScans, SetsUpTheChannelsTheTriggerAndTheBuffer) {
  {
    const IioBuffer sensor("ina226", channels_, "trig7", sys(), dev());
    EXPECT_EQ(get("scan_elements/in_current0_en"), "1");
    EXPECT_EQ(get("scan_elements/in_current1_en"), "1");
    EXPECT_EQ(get("scan_elements/in_timestamp_en"), "0");
    EXPECT_EQ(get("trigger/current_trigger"), "trig7");
    EXPECT_EQ(get("buffer/length"), "64");
    EXPECT_EQ(get("buffer/enable"), "1");
  }
  EXPECT_EQ(get("buffer/enable"), "0");
}

TEST_F(IioScans, TheNewestScanCountsAndCountsOnce) {
  IioBuffer sensor("ina226", channels_, "", sys(), dev());
  EXPECT_EQ(sensor.isr_read(0).error(), Error::missing);
  scan(1'000, 3);
  scan(600, 5);
  EXPECT_NEAR(ampere(sensor.isr_read(0)), 1.0, 1e-7);
  EXPECT_NEAR(ampere(sensor.isr_read(1)), 0.0025, 1e-7);
  EXPECT_EQ(sensor.overtaken(), 1U);
  EXPECT_EQ(sensor.isr_read(0).error(), Error::missing);
  EXPECT_EQ(sensor.isr_read(1).error(), Error::missing);
  scan(-200, 0);
  EXPECT_NEAR(ampere(sensor.isr_read(0)), -1.0, 1e-7);
  EXPECT_EQ(sensor.isr_read(2).error(), Error::out_of_range);
}

TEST_F(IioScans, APartOfAScanIsAFault) {
  IioBuffer sensor("ina226", channels_, "", sys(), dev());
  ASSERT_EQ(::write(pipe_, "abc", 3), 3);
  EXPECT_EQ(sensor.isr_read(0).error(), Error::failed);
}

TEST_F(IioScans, ElementsThatAreNoSingleValueAreRefused) {
  put("scan_elements/in_current0_type", "le:s16/16X3>>0");
  EXPECT_NE(complaint_of([&] {
              IioBuffer("ina226", channels_, "", sys(), dev());
            }).find("_type is le:s16/16X3>>0"),
            std::string::npos);
  put("scan_elements/in_current0_type", "le:s16/16>>0");
  put("scan_elements/in_current0_index", "0");
  EXPECT_NE(
      complaint_of([&] { IioBuffer("ina226", channels_, "", sys(), dev()); }).find("_index is '0'"),
      std::string::npos);
}

TEST_F(IioDevice, ADeviceWithoutBufferIsRefused) {
  fs::remove_all(device_ / "buffer");
  EXPECT_NE(complaint_of([&] {
              IioBuffer("ina226", channels_, "", sys(), dev());
            }).find("buffer/enable: cannot be set to 0"),
            std::string::npos);
}

TEST_F(IioDevice, AMissingCharacterDeviceIsNamed) {
  EXPECT_NE(complaint_of([&] {
              IioBuffer("ina226", channels_, "", sys(), dev());
            }).find("iio:device3: No such file or directory"),
            std::string::npos);
}

}  // namespace
}  // namespace hal::linux_os
