#include "host_sim/monitor/http/history_csv.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>

namespace host_sim::monitor {
namespace {

std::string ppb_text(std::uint32_t ppb) {
  constexpr std::uint32_t kOne = 1'000'000'000;
  return fmt::format("{}.{:09}", ppb / kOne, ppb % kOne);
}

}  // namespace

std::string history_csv(const NodeView& node) {
  std::string text = "time_s,damage,damage_rate_per_h\n";
  constexpr std::int64_t kSecond_us = 1'000'000;
  for (const DamagePoint& point : node.curve) {
    const std::int64_t time_us = point.time_ns / 1000;
    fmt::format_to(std::back_inserter(text), "{}.{:06},{},{}\n", time_us / kSecond_us,
                   time_us % kSecond_us, ppb_text(point.damage_ppb),
                   point.rate_ppb_per_h ? ppb_text(*point.rate_ppb_per_h) : "");
  }
  return text;
}

}  // namespace host_sim::monitor
