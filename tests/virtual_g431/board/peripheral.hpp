#pragma once

#include <algorithm>
#include <cstdint>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace virtual_g431 {

constexpr std::uint32_t bit(unsigned position) {
  return std::uint32_t{1} << position;
}
/// The bits `high` .. `low` of a word.
constexpr std::uint32_t field(std::uint32_t word, unsigned high, unsigned low) {
  return static_cast<std::uint32_t>(word >> low & ((std::uint64_t{1} << (high - low + 1)) - 1));
}
inline std::string hex(std::uint32_t value) {
  std::ostringstream text;
  text << "0x" << std::hex << std::setw(8) << std::setfill('0') << value;
  return text.str();
}

/// Collects what the firmware did against the reference manual. Tests want it to be empty.
class Rules {
 public:
  /// Each text is kept once.
  void broken(const std::string& what) {
    if (std::find(broken_.begin(), broken_.end(), what) == broken_.end()) {
      broken_.push_back(what);
    }
  }
  void require(bool holds, const std::string& what) {
    if (!holds) {
      broken(what);
    }
  }
  [[nodiscard]] const std::vector<std::string>& all() const { return broken_; }
  void forget() { broken_.clear(); }

 private:
  std::vector<std::string> broken_;
};

/// The registers of one peripheral; offsets from its base address.
class Peripheral {
 public:
  Peripheral() = default;
  Peripheral(const Peripheral&) = delete;
  Peripheral& operator=(const Peripheral&) = delete;
  virtual ~Peripheral() = default;

  virtual std::uint32_t read(std::uint32_t offset) = 0;
  virtual void write(std::uint32_t offset, std::uint32_t value) = 0;
  /// As after any reset of the device.
  virtual void reset() = 0;
};

}  // namespace virtual_g431
