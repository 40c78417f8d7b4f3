#include "firmware/boards/linux/report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

namespace boards::linux_controller {
namespace {

using Json = nlohmann::ordered_json;

std::string_view name_of(hal::CanState state) {
  switch (state) {
    case hal::CanState::active:
      return "active";
    case hal::CanState::warning:
      return "warning";
    case hal::CanState::passive:
      return "passive";
    case hal::CanState::off:
      return "off";
  }
  return "unknown";
}

std::string_view name_of(hal::linux_os::TimestampSource source) {
  switch (source) {
    case hal::linux_os::TimestampSource::none:
      return "none";
    case hal::linux_os::TimestampSource::software:
      return "software";
    case hal::linux_os::TimestampSource::hardware:
      return "hardware";
  }
  return "unknown";
}

// All bits, so that two runs can be compared exactly.
std::string hex_of(const lifemodel::Damage& damage) {
  std::string text;
  for (std::size_t i = damage.words().size(); i-- > 0;) {
    text += fmt::format("{:08x}", damage.words()[i]);
  }
  return text;
}

Json life_of(const storage::LifeRecord& life) {
  return {{"tendon", life.tendon},
          {"epoch", life.epoch},
          {"damage_ppb", life.epoch_damage.parts_per_billion()},
          {"damage", hex_of(life.epoch_damage)},
          {"lifetime_damage_ppb", life.lifetime_damage.parts_per_billion()},
          {"cycles", life.epoch_cycles},
          {"flags", life.flags}};
}

}  // namespace

std::string to_json(const Report& report) {
  Json lives = Json::array();
  for (const storage::LifeRecord& life : report.lives) {
    lives.push_back(life_of(life));
  }
  const hal::linux_os::SocketCanCounts& counts = report.counts;
  const Json json{
      {"node", report.node},
      {"tendons", lives},
      {"loop",
       {{"periods", report.periods},
        {"missed_deadlines", report.missed_deadlines},
        {"p99_jitter_us", report.p99_jitter_us},
        {"worst_jitter_us", report.worst_jitter_us}}},
      {"store",
       {{"saved", report.saved == hal::Error::none},
        {"sequence", report.sequence},
        {"worst_unsaved_ppb", report.worst_unsaved_ppb}}},
      {"can",
       {{"state", name_of(report.bus.state)},
        {"bus_offs", report.bus.bus_offs},
        {"lost", report.bus.lost},
        {"sent", counts.sent},
        {"queue_full", counts.queue_full},
        {"refused", counts.refused},
        {"downs", counts.downs},
        {"reopened", counts.reopened},
        {"restarts", counts.faults.restarts},
        {"transmit_timeouts", counts.faults.transmit_timeouts},
        {"timestamps", name_of(counts.timestamp_source)}}},
  };
  return json.dump(2) + "\n";
}

std::string to_text(const Report& report) {
  std::string text;
  for (const storage::LifeRecord& life : report.lives) {
    text += fmt::format("tendon {}: damage {} ppb in epoch {}, {} cycles\n", life.tendon,
                        life.epoch_damage.parts_per_billion(), life.epoch, life.epoch_cycles);
  }
  text += fmt::format("{} periods, {} missed, 99 % late by at most {} us, worst {} us\n",
                      report.periods, report.missed_deadlines, report.p99_jitter_us,
                      report.worst_jitter_us);
  return text;
}

}  // namespace boards::linux_controller
