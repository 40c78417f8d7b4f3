#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "host_sim/report/replay/captions.hpp"
#include "host_sim/report/replay/html.hpp"
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

TEST(ReplayPage, HasAPlaceForEachPlotThatHasData) {
  for (const samples::Sample& sample : samples::all()) {
    EXPECT_EQ(count_of(page_of(sample.report), " data-chart=\""),
              static_cast<std::size_t>(sample.charts))
        << sample.name;
  }
}

}  // namespace

}  // namespace host_sim
