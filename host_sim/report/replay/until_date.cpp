#include <fmt/format.h>

#include <cstdint>
#include <sstream>

#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/frame.hpp"
#include "host_sim/report/page/number_text.hpp"
#include "host_sim/report/replay/assets.hpp"
#include "host_sim/report/replay/sections.hpp"

namespace host_sim::sections {
namespace {

std::string lead(const UntilDate& until) {
  const AskedUntil& asked = until.asked;
  const std::string wanted =
      fmt::format("{} of {} are {} repeats of this profile",
                  counted_text(static_cast<std::uint64_t>(asked.days), "day"),
                  quantity_text(asked.hours_per_day, "h"), number_text(until.repeats, 4));
  if (until.lasts_as_it_is()) {
    return fmt::format("{}, which the wire lasts as it is at a risk of {}.", wanted,
                       percent_text(asked.risk));
  }
  return fmt::format(
      "{}; as it is the wire lasts {} at a risk of {}. Less tension, the load scaled as a whole, "
      "or "
      "a slower pace lets it last.",
      wanted, quantity_text(until.hours_to_risk, "h"), percent_text(asked.risk));
}

std::string tiles(const UntilDate& until) {
  const auto given_up = [](double share) { return percent_text(share) + " given up"; };
  return elements::tile("Highest tension", quantity_text(until.highest_tension_N, "N", 4),
                        fmt::format("now {}; {}", quantity_text(until.peak_tension_N, "N", 4),
                                    given_up(until.tension_given_up()))) +
         elements::tile("Or cycles in a time", percent_text(until.pace),
                        "of now; " + given_up(until.cycles_given_up())) +
         elements::tile("Life gained", fmt::format("{} times", number_text(until.life_gained())),
                        "to a risk of " + percent_text(until.asked.risk)) +
         elements::tile("Risk at the date", percent_text(until.risk_with),
                        percent_text(until.risk_as_it_is) + " as it is");
}

}  // namespace

std::string until_date(const ReplayReport& report) {
  if (!report.until_date) {
    return {};
  }
  const UntilDate& until = *report.until_date;
  std::ostringstream html;
  fill_template(html, replay_assets::until_date_html,
                {{"date", html_escape(until.asked.date)},
                 {"lead", html_escape(lead(until))},
                 {"tiles", tiles(until)}});
  return html.str();
}

}  // namespace host_sim::sections
