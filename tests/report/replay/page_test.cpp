#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "host_sim/report/page/number_text.hpp"
#include "host_sim/report/replay/captions.hpp"
#include "host_sim/report/replay/given_survival.hpp"
#include "host_sim/report/replay/html.hpp"
#include "host_sim/report/replay/loop.hpp"
#include "tests/report/page/page_text.hpp"
#include "tests/report/replay/samples.hpp"

namespace host_sim {
namespace {

ReplayReport worn(double damage, double b10) {
  ReplayReport report;
  report.duration_s = 60;
  report.cycles = {20, 2};
  report.damage.total = damage;
  report.repeats_to.B10 = b10;
  return report;
}

TEST(Verdict, CountsWholeRepeats) {
  EXPECT_EQ(verdict(worn(0.021, 38.97)),
            "This profile, 60\u00a0s long, uses 2.1\u00a0% of the wire's life; it can be repeated "
            "38 times until 10\u00a0% of wires have broken (B10).");
  EXPECT_EQ(verdict(worn(0.5, 1.4)),
            "This profile, 60\u00a0s long, uses 50\u00a0% of the wire's life; it can be repeated "
            "once until 10\u00a0% of wires have broken (B10).");
}

TEST(Verdict, SpeaksInPowersOfTenWhereNobodyCounts) {
  EXPECT_EQ(verdict(worn(2.1e-9, 3.26e8)),
            "This profile, 60\u00a0s long, uses 2.1×10⁻⁹ of the wire's life; it can be repeated "
            "3.26×10⁸ times until 10\u00a0% of wires have broken (B10).");
}

TEST(Verdict, SaysWhenOnePassIsTooMuch) {
  ReplayReport report = worn(1.25, 0.5);
  report.survival_probability = 0.023;
  EXPECT_EQ(verdict(report),
            "This profile, 60\u00a0s long, uses 125\u00a0% of the wire's life; only 2.3\u00a0% of "
            "wires survive one pass.");
  report.damage.total = 1250;
  report.survival_probability = 0;
  EXPECT_EQ(verdict(report),
            "This profile, 60\u00a0s long, uses 1250 times the wire's life; only 0\u00a0% of wires "
            "survive one pass.");
}

TEST(Verdict, SaysWhenNothingIsUsed) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ReplayReport idle = worn(0, kInfinity);
  EXPECT_EQ(verdict(idle),
            "This profile, 60\u00a0s long, uses too little of the wire's life to measure.");
  idle.cycles = {};
  EXPECT_EQ(verdict(idle),
            "This profile, 60\u00a0s long, holds no load cycle and uses none of the wire's life.");
}

TEST(Verdict, SaysWhenTheDamageIsUnknown) {
  EXPECT_EQ(verdict(worn(std::numeric_limits<double>::quiet_NaN(), 0)),
            "This profile, 60\u00a0s long, uses an amount of the wire's life that could not be "
            "worked out.");
}

using nlohmann::json;
using page_text::count_of;
using page_text::data_in;
using testing::HasSubstr;
using testing::Not;

std::string page_of(const ReplayReport& report) {
  std::ostringstream out;
  write_replay_report(out, report);
  return out.str();
}

TEST(ReplayPage, ShowsTheKeyNumbers) {
  ReplayReport report = samples::typical();
  report.damage.total = 0.0213;
  report.repeats_to = {32.25, 44.5, 43.75, 54.125};
  report.equivalent_effective_tension_N = 39.875;
  report.survival_probability = 0.75;
  report.cycles = {98'765, 43};
  const std::string page = page_of(report);
  EXPECT_THAT(page, HasSubstr("<dd class=\"value\">0.0213</dd>"));
  EXPECT_THAT(page, HasSubstr("it can be repeated 32 times"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number\">32.25</td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number\">44.5</td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number\">43.75</td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number\">54.125</td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number\">39.875\u00a0N</td>"));
  EXPECT_THAT(page, HasSubstr("<dd class=\"value\">75\u00a0%</dd>"));
  EXPECT_THAT(page, HasSubstr("<dd class=\"value\">98\u202f765\u00a0cycles</dd>"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">ultimate tension</th>"
                              "<td class=\"number\">177.4\u00a0N</td>"));
}

TEST(ReplayPage, EmbedsItsDataUnchanged) {
  const ReplayReport report = samples::typical();
  const json data = data_in(page_of(report));
  EXPECT_EQ(data["profile_name"], report.profile_name);
  EXPECT_EQ(data["tension"]["time_s"], report.tension.time_s);
  EXPECT_EQ(data["tension"]["low_N"], report.tension.low_N);
  EXPECT_EQ(data["tension"]["high_N"], report.tension.high_N);
  EXPECT_EQ(data["tension"]["samples_per_bucket"], report.tension.samples_per_bucket);
  EXPECT_EQ(data["range_mean"]["count"], report.range_mean.count);
  EXPECT_EQ(data["range_mean"]["damage"], report.range_mean.damage);
  EXPECT_EQ(data["range_mean"]["ranges"], report.range_mean.ranges);
  EXPECT_EQ(data["range_mean"]["mean_min_N"], report.range_mean.mean_min_N);
  EXPECT_EQ(data["trajectory"]["time_s"], report.trajectory.time_s);
  EXPECT_EQ(data["trajectory"]["damage"], report.trajectory.damage);
  const json& points = data["turning_points"];
  ASSERT_EQ(points["time_s"].size(), report.turning_points.points.size());
  for (std::size_t i = 0; i < report.turning_points.points.size(); ++i) {
    EXPECT_EQ(points["time_s"][i], report.turning_points.points[i].time_s);
    EXPECT_EQ(points["tension_N"][i], report.turning_points.points[i].tension_N);
  }
  const json& summary = data["summary"];
  EXPECT_EQ(summary["samples"], report.samples);
  EXPECT_EQ(summary["cycles"]["closed"], report.cycles.closed);
  EXPECT_EQ(summary["cycles"]["open_half"], report.cycles.open_half);
  EXPECT_EQ(summary["damage"]["closed"], report.damage.closed);
  EXPECT_EQ(summary["damage"]["open"], report.damage.open);
  EXPECT_EQ(summary["damage"]["total"], report.damage.total);
  EXPECT_EQ(summary["reference_damage"]["total"], report.reference_damage.total);
  EXPECT_EQ(summary["relative_error"], report.relative_error);
  EXPECT_EQ(summary["repeats_to"]["B10"], report.repeats_to.B10);
  EXPECT_EQ(summary["repeats_to"]["B50"], report.repeats_to.B50);
  EXPECT_EQ(summary["repeats_to"]["mean"], report.repeats_to.mean);
  EXPECT_EQ(summary["repeats_to"]["B90"], report.repeats_to.B90);
  EXPECT_EQ(summary["model_digest"], report.model_digest);
}

TEST(ReplayPage, EmbedsNullForNumbersThatAreNotFinite) {
  ReplayReport report = samples::typical();
  report.repeats_to.B10 = std::numeric_limits<double>::infinity();
  report.equivalent_effective_tension_N = std::numeric_limits<double>::quiet_NaN();
  const json summary = data_in(page_of(report))["summary"];
  EXPECT_TRUE(summary["repeats_to"]["B10"].is_null());
  EXPECT_TRUE(summary["equivalent_effective_tension_N"].is_null());
}

TEST(ReplayPage, NoTextLeavesItsPlace) {
  const std::string tame = page_of(samples::typical());
  const std::string page = page_of(samples::hostile());
  for (const char* const piece : {"<script", "</script", "<style", "<img", "<!--", "-->"}) {
    EXPECT_EQ(count_of(page, piece), count_of(tame, piece)) << piece;
  }
  EXPECT_THAT(page, Not(HasSubstr("<plaintext")));
  EXPECT_THAT(page, Not(HasSubstr("onclick='throw")));
  EXPECT_THAT(page, Not(HasSubstr("\xff")));
  EXPECT_THAT(page, HasSubstr("{{title}} Überlast 腕 \ufffd"));
  EXPECT_EQ(data_in(page)["model_name"], samples::hostile().model_name);
}

TEST(ReplayPage, IsSelfContained) {
  for (const samples::Sample& sample : samples::all()) {
    const std::string page = page_of(sample.report);
    EXPECT_THAT(page, HasSubstr("<h1>"));
    EXPECT_EQ(page_text::reference_out_of(page), "") << sample.name;
    EXPECT_THAT(page, HasSubstr("content=\"default-src 'none'; style-src 'unsafe-inline'; "
                                "script-src 'unsafe-inline'; img-src data:\""));
  }
}

TEST(ReplayPage, CarriesTheLicenceOfTheChartLibrary) {
  const std::string page = page_of(samples::typical());
  const std::size_t licence = page.find("The MIT License");
  ASSERT_NE(licence, std::string::npos);
  EXPECT_LT(page.rfind("<!--", licence), licence);
  EXPECT_GT(page.find("THE SOFTWARE IS PROVIDED \"AS IS\""), licence);
  EXPECT_LT(page.find("THE SOFTWARE IS PROVIDED \"AS IS\""), page.find("-->", licence));
}

TEST(ReplayPage, IsTheSameForTheSameData) {
  EXPECT_EQ(page_of(samples::typical()), page_of(samples::typical()));
}

TEST(ReplayPage, ExplainsFlagsInWords) {
  ReplayReport report = samples::typical();
  EXPECT_THAT(page_of(report), HasSubstr("every cycle was counted exactly"));
  report.flags = {"overload"};
  EXPECT_THAT(page_of(report), HasSubstr("The tension reached the strength of the wire."));
  EXPECT_THAT(page_of(report), Not(HasSubstr("every cycle was counted exactly")));
  report.flags = {"a_later_flag"};
  EXPECT_THAT(page_of(report), HasSubstr("a_later_flag"));
  report.flags = {};
  report.warnings = {"recorded at 100 Hz"};
  EXPECT_THAT(page_of(report), HasSubstr("<li>recorded at 100 Hz</li>"));
}

TEST(ReplayPage, EveryFlagOfTheEstimatorIsExplained) {
  ReplayReport report = samples::typical();
  report.flags = {"saturated", "overload", "negative_tension",
                  "gap",       "overrun",  "residue_overflow"};
  EXPECT_THAT(page_of(report), Not(HasSubstr("this page has no explanation")));
}

TEST(ReplayPage, TellsWhatTheWireWasFoundIn) {
  ReplayReport report = samples::survivor(0.4, "9", true);
  std::string page = page_of(report);
  EXPECT_THAT(page, HasSubstr("<dt>Highest tension</dt><dd class=\"value\">31.2\u00a0%</dd>"
                              "<dd class=\"note\">of the ultimate one, 55.44\u00a0N</dd>"));
  EXPECT_THAT(page, HasSubstr("<dt>Above 50\u00a0%</dt><dd class=\"value\">12</dd>"
                              "<dd class=\"note\">excursions</dd>"));
  EXPECT_THAT(page, HasSubstr("<dt>Above 70\u00a0%</dt><dd class=\"value\">1</dd>"
                              "<dd class=\"note\">excursion</dd>"));
  EXPECT_THAT(page, HasSubstr("<dt>Above 90\u00a0%</dt><dd class=\"value\">0</dd>"));
  EXPECT_THAT(page, HasSubstr("<dt>Below the minimum</dt><dd class=\"value\">1.5\u00a0s</dd>"
                              "<dd class=\"note\">under 0.4\u00a0N</dd>"));
  EXPECT_THAT(page, HasSubstr("<dt>Hung loose</dt><dd class=\"value\">1</dd>"));
  EXPECT_THAT(page, HasSubstr("<dt>Wire</dt><dd class=\"value\">whole</dd>"));
  EXPECT_THAT(page, HasSubstr("<li>Loose at 12.5 s, line 2502 of the profile.</li>"));
  report.broken = true;
  EXPECT_THAT(page_of(report), HasSubstr("<dt>Wire</dt><dd class=\"value\">broken</dd>"));
  report.motion = false;
  report.minimum_tension_N = 0;
  page = page_of(report);
  EXPECT_EQ(count_of(page, "<dd class=\"value\">not watched</dd>"), 3U);
}

// B10 of the paper's shape is 0.684648: from there 10, 50 and 90 % are 0.0847407, 0.278179 and
// 0.474797 further (tests/lifemodel/conditional_test.cpp).
TEST(ReplayPage, TellsOfAWireThatIsWholeNow) {
  ReplayReport report = samples::survivor(0.684648495, "9", false);
  const double damage = report.damage.total;
  std::string page = page_of(report);
  EXPECT_THAT(page, HasSubstr("A wire that is whole at damage 0.685: "));
  EXPECT_THAT(page, HasSubstr("it has lasted so far. The model does not say"));
  EXPECT_THAT(page, HasSubstr("how well its life is known: no intervals."));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">10\u00a0%</th><td class=\"number\">" +
                              number_text(0.0847407 / damage, 4) +
                              "</td><td class=\"number\">not known</td>"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">50\u00a0%</th><td class=\"number\">" +
                              number_text(0.278179 / damage, 4)));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">90\u00a0%</th><td class=\"number\">" +
                              number_text(0.474797 / damage, 4)));
  const double risk =
      -std::expm1(std::pow(0.684648495, 5.94) - std::pow(0.684648495 + 9 * damage, 5.94));
  EXPECT_THAT(page, HasSubstr("Within 9 repeats it breaks with a probability of " +
                              percent_text(risk) + ", a new wire with "));
  page = page_of(samples::survivor(0, "0.5h", true));
  EXPECT_THAT(page, HasSubstr("Within 0.5h, 30 repeats it breaks"));
  EXPECT_THAT(page, Not(HasSubstr(", a new wire with")));
  EXPECT_THAT(page, Not(HasSubstr("has lasted so far")));
  EXPECT_THAT(page_of(samples::typical()), Not(HasSubstr("whole at damage")));
}

TEST(ReplayPage, TellsWhatLastsUntilADate) {
  ReplayReport report = samples::typical();
  EXPECT_THAT(page_of(report), Not(HasSubstr("Until 2")));
  report.until_date = UntilDate{.asked = {"2027-06-30", 220, 8, 0.1},
                                .used = 0.4,
                                .repeats = 660,
                                .reachable = true,
                                .hours_to_risk = 440,
                                .risk_as_it_is = 0.75,
                                .peak_tension_N = 60,
                                .highest_tension_N = 45,
                                .pace = 0.25,
                                .risk_with = 0.1};
  const std::string page = page_of(report);
  EXPECT_THAT(page, HasSubstr("<h2 id=\"until-heading\">Until 2027-06-30</h2>"));
  EXPECT_THAT(page,
              HasSubstr("220\u00a0days of 8\u00a0h are 660 repeats of this profile; as it is the "
                        "wire lasts 440\u00a0h at a risk of 10\u00a0%."));
  EXPECT_THAT(page, HasSubstr("<dd class=\"value\">45\u00a0N</dd><dd class=\"note\">now 60\u00a0N; "
                              "25\u00a0% given up</dd>"));
  EXPECT_THAT(page, HasSubstr("<dd class=\"value\">25\u00a0%</dd><dd class=\"note\">of now; "
                              "75\u00a0% given up</dd>"));
  EXPECT_THAT(page, HasSubstr("<dd class=\"value\">4 times</dd>"));
  EXPECT_THAT(page,
              HasSubstr("<dd class=\"value\">10\u00a0%</dd><dd class=\"note\">75\u00a0% as it is"));
  report.until_date->hours_to_risk = 2000;
  EXPECT_THAT(page_of(report), HasSubstr("which the wire lasts as it is at a risk of 10\u00a0%."));
  report.until_date->asked.date = "<script>throw 5</script>";
  EXPECT_THAT(page_of(report), Not(HasSubstr("<script>throw 5")));
}

const Layer* layer_of(const Chart& chart, std::string_view name) {
  const auto found = std::ranges::find(chart.layers, name, &Layer::name);
  return found == chart.layers.end() ? nullptr : &*found;
}

TEST(BreakChart, HasTheWireWithItsIntervalAndANewOne) {
  const Chart chart = break_chart(samples::survivor(0.4, "0.5h", true));
  const Layer* wire = layer_of(chart, "This wire, damage 0.4");
  const Layer* band = layer_of(chart, "95\u00a0% interval of the fit");
  const Layer* of_new = layer_of(chart, "A new wire");
  const Layer* marks = layer_of(chart, "10, 50 and 90 %");
  ASSERT_TRUE(wire && band && of_new && marks && layer_of(chart, "The horizon"));
  const std::size_t size = wire->x.size();
  ASSERT_EQ(band->x.size(), 2 * size);
  for (std::size_t i = 1; i < size; ++i) {
    EXPECT_EQ(band->x[i], band->x[2 * size - 1 - i]);
    EXPECT_LT(band->y[i], wire->y[i]);
    EXPECT_GT(band->y[2 * size - 1 - i], wire->y[i]);
    EXPECT_LT(of_new->y[i], wire->y[i]);
  }
  EXPECT_THAT(marks->y, testing::ElementsAre(10, 50, 90));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto after = std::ranges::lower_bound(wire->x, marks->x[i]) - wire->x.begin();
    EXPECT_LE(wire->y[static_cast<std::size_t>(after) - 1], marks->y[i]);
    EXPECT_GE(wire->y[static_cast<std::size_t>(after)], marks->y[i]);
  }
}

TEST(BreakChart, LeavesOutWhatIsNotKnownOrTheSame) {
  const Chart without_fit = break_chart(samples::survivor(0.4, "0.5h", false));
  EXPECT_TRUE(std::ranges::none_of(
      without_fit.layers, [](const Layer& layer) { return layer.kind == Layer::Kind::area; }));
  const Chart of_new = break_chart(samples::survivor(0, "1e9", true));
  EXPECT_FALSE(of_new.layers.empty());
  EXPECT_TRUE(std::ranges::none_of(of_new.layers, [](const Layer& layer) { return layer.dashed; }));
  EXPECT_EQ(layer_of(of_new, "The horizon"), nullptr);  // far beyond
  EXPECT_TRUE(break_chart(samples::typical()).layers.empty());
}

TEST(ReplayPage, DrawsTheLoopOfARecordingWithArrowsAndGaps) {
  ReplayReport report = samples::typical();
  EXPECT_TRUE(loop_chart(report).layers.empty());
  EXPECT_THAT(page_of(report), Not(HasSubstr("data-chart=\"loop\"")));
  report.loop = {{2, 3, 4, 15, 16}, {10, 12, 14, 13, 11}, {8, 10, 12, 9, 7}};
  const Chart chart = loop_chart(report);
  ASSERT_EQ(chart.layers.size(), 1U);
  EXPECT_GT(chart.layers[0].heads, 0);
  EXPECT_EQ(chart.layers[0].x.size(), 6U);
  EXPECT_TRUE(std::isnan(chart.layers[0].x[3]) && std::isnan(chart.layers[0].y[3]));
  EXPECT_EQ(chart.layers[0].y[4], 9);
  EXPECT_THAT(page_of(report), HasSubstr("From 2\u00a0s to 16\u00a0s: the output tension"));
}

TEST(ReplayPage, CountsTheGapsOfTheProfile) {
  ReplayReport report = samples::typical();
  EXPECT_THAT(captions::tension(report), Not(HasSubstr("gap")));
  report.gaps = 2;
  report.missing_samples = 7;
  EXPECT_THAT(captions::tension(report),
              HasSubstr(" 2\u00a0gaps, in which 7\u00a0samples are missing."));
  report.gaps = 1;
  report.missing_samples = 1;
  report.tension.gaps = {1};
  EXPECT_THAT(captions::tension(report),
              HasSubstr(" 1\u00a0gap, in which 1 sample is missing, left open."));
}

TEST(ReplayPage, HasAPlaceForEachPlotThatHasData) {
  for (const samples::Sample& sample : samples::all()) {
    EXPECT_EQ(count_of(page_of(sample.report), " data-chart=\""),
              static_cast<std::size_t>(sample.charts))
        << sample.name;
  }
}

}  // namespace

}  // namespace host_sim
