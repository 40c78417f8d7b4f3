#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "host_sim/fleet/fleet_plan.hpp"

namespace host_sim::fleet {
namespace {

bool continues_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U;
}

/// A content line in lines of at most 75 octets, of which none ends within a character: RFC 5545,
/// 3.1.
std::string folded(std::string_view line) {
  constexpr std::size_t kMostOctets = 75;
  std::string text;
  std::size_t room = kMostOctets;
  while (line.size() > room) {
    std::size_t end = room;
    while (continues_character(line[end])) {
      --end;
    }
    text += line.substr(0, end);
    text += "\r\n ";
    line.remove_prefix(end);
    room = kMostOctets - 1;
  }
  text += line;
  return text + "\r\n";
}

/// RFC 5545, 3.3.11.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\' || c == ';' || c == ',') {
      result += '\\';
    }
    result += c;
  }
  return result;
}

std::string basic_date(Date date) {
  std::string text = date_text(date);
  std::erase(text, '-');
  return text;
}

/// The same for a name in every plan, so that a later plan moves an event: FNV-1a of 64 bits.
std::string uid_of(std::string_view name) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : name) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  }
  return fmt::format("{:016x}@fleet.host_sim", hash);
}

struct Event {
  std::string uid;
  Date date;
  std::string summary;
  std::string description;
};

std::string event_text(const Event& event, Date today) {
  std::string text;
  for (const std::string& line :
       {std::string("BEGIN:VEVENT"), "UID:" + event.uid,
        "DTSTAMP:" + basic_date(today) + "T000000Z", "DTSTART;VALUE=DATE:" + basic_date(event.date),
        "DTEND;VALUE=DATE:" + basic_date(event.date + std::chrono::days(1)),
        "SUMMARY:" + escaped(event.summary), "DESCRIPTION:" + escaped(event.description),
        std::string("TRANSP:TRANSPARENT"), std::string("END:VEVENT")}) {
    text += folded(line);
  }
  return text;
}

/// When the first tendon is at the horizon.
Date horizon_day(const Fleet& fleet, const PlanRequest& request) {
  double days = request.horizon.length;
  if (request.horizon.kind == Horizon::Kind::operation) {
    double most_h = 0;
    for (const Tendon& tendon : fleet.tendons) {
      most_h = std::max(most_h, tendon.hours_per_day);
    }
    days /= most_h;
  }
  return request.today +
         std::chrono::days(static_cast<int>(std::min(std::floor(days), kLongestHorizon_days)));
}

}  // namespace

std::string plan_calendar(const Fleet& fleet, const PlanRequest& request, const FleetPlan& plan) {
  std::string text = folded("BEGIN:VCALENDAR") + folded("VERSION:2.0") +
                     folded("PRODID:-//tendonlife//host_sim fleet//EN") +
                     folded("CALSCALE:GREGORIAN");
  for (const std::size_t i : by_urgency(plan)) {
    const TendonPlan& planned = plan.tendons[i];
    if (planned.due && planned.replace.date) {
      const Tendon& tendon = fleet.tendons[i];
      text += event_text(
          {uid_of("tendon " + tendon.name), *planned.replace.date, "Replace tendon " + tendon.name,
           fmt::format("Damage {:.4f} on {}; the risk of a break until this day is "
                       "{:g} %, until the horizon of {} {:.1f} %.",
                       tendon.damage, date_text(request.today), 100 * request.risk,
                       request.horizon.text, 100 * planned.risk)},
          request.today);
    }
  }
  text += event_text(
      {uid_of("horizon"), horizon_day(fleet, request), "Plan the fleet again",
       fmt::format("The plan of {} ends here; it takes {} spares run to break, {} "
                   "on condition.",
                   date_text(request.today), plan.breaks.count, plan.on_condition.count)},
      request.today);
  return text + folded("END:VCALENDAR");
}

}  // namespace host_sim::fleet
