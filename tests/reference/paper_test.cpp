// The numbers that the paper's equations and printed constants give, worked out apart from this
// code; where the paper prints another number, that one is in paper.cpp and the reason is in the
// README.
#include "tests/reference/paper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include "host_sim/reference/equations.hpp"
#include "host_sim/reference/reference.hpp"

namespace host_sim::reference::testing {
namespace {

PaperRow row(const std::string& quantity) {
  const std::vector<PaperRow> rows = paper_rows();
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const PaperRow& r) { return r.quantity == quantity; });
  if (found == rows.end()) {
    ADD_FAILURE() << "no row " << quantity;
    return {};
  }
  return *found;
}

void expect_ours(const std::string& quantity, const std::vector<double>& expected,
                 double tolerance) {
  const PaperRow actual = row(quantity);
  ASSERT_EQ(actual.ours.size(), expected.size()) << quantity;
  ASSERT_EQ(actual.paper.size(), expected.size()) << quantity;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(actual.ours[i], expected[i], tolerance) << quantity;
  }
}

TEST(Paper, EffectiveTensionOfEachBend) {
  expect_ours("T_eff at 270, 315, 360, 405, 450, 540 deg (N)",
              {35.16, 42.54, 50.76, 60.12, 70.99, 99.75}, 0.006);
  expect_ours("T_eff of the upper-arm application (N)", {39.98}, 0.006);
}

TEST(Paper, AFrictionThatAlsoPrintsAs0128GivesAllPrintedEffectiveTensions) {
  const std::array<double, 7> printed_N{35.1, 42.5, 50.7, 60.0, 70.8, 99.4, 39.9};
  const std::vector<double> tensions_N = effective_tensions_N(0.1278);
  ASSERT_EQ(tensions_N.size(), printed_N.size());
  for (std::size_t i = 0; i < printed_N.size(); ++i) {
    EXPECT_EQ(std::round(10 * tensions_N[i]), std::round(10 * printed_N[i]));
  }
}

// 60 s of the upper arm at one cycle a second, sample by sample through slip in both directions:
// 28.5 to 48.5 N of output must count as cycles of T_eff = 39.98 N.
TEST(Paper, TheApplicationCountedFromItsSamples) {
  constexpr Constants kPaper{.ultimate_tension_N = 177.4,
                             .hysteresis_N = 0.2,
                             .ipl_scale = 1.53e5,
                             .ipl_exponent = 1.38,
                             .weibull_shape = 5.94};
  constexpr int kCycles = 60;
  const double efficiency = capstan_efficiency(0.128, 1.5 * std::numbers::pi);
  Reference reference(kPaper);
  reference.push(28.5 * efficiency);
  for (int cycle = 0; cycle < kCycles; ++cycle) {
    for (int step = 0; step <= 20; ++step) {
      reference.push(input_tension_from_output(28.5 + step, efficiency, Direction::kPulling));
    }
    for (int step = 20; step >= 0; --step) {
      reference.push(input_tension_from_output(28.5 + step, efficiency, Direction::kReleasing));
    }
  }
  const double life_cycles = 1.53e5 / std::pow(39.9834, 1.38);
  EXPECT_NEAR(reference.reading().damage.total * life_cycles / kCycles, 1.0, 1e-5);
}

TEST(Paper, MeanLifeOfEachLevel) {
  expect_ours("mean life at 270, 315, 360, 405, 450 deg, of each level's own fit (cycles)",
              {991.1, 782.2, 634.5, 506.4, 382.4}, 0.06);
}

TEST(Paper, LeastSquaresOfTheScaleParameters) {
  expect_ours("A by least squares", {1.54e5}, 500);
  expect_ours("gamma by least squares", {1.384}, 0.0006);
  expect_ours("RMSE of that fit (cycles)", {12.6}, 0.06);
}

TEST(Paper, MeanLifeWhereItWasMeasured) {
  expect_ours("mean life at 35.1 N (cycles)", {1045.5}, 0.06);
  expect_ours("mean life at 39.9 N (cycles)", {876}, 0.6);
  expect_ours("gamma between those two mean lives", {1.45}, 0.006);
  expect_ours("prediction above the measured mean at 270 deg (%)", {5.29}, 0.006);
  expect_ours("measured mean above the prediction in the application (%)", {14.15}, 0.006);
}

TEST(Paper, ExoGlove) {
  expect_ours("Exo-glove: T_eff (N)", {25.51}, 0.006);
  expect_ours("Exo-glove: B10, mean, B90 (cycles)", {1199.4, 1624.4, 2016.0}, 0.06);
}

// The mean that the paper prints is the scale parameter: alpha = 1.74e3 gives its B10 and B90.
TEST(Paper, ThePrintedMeanOfTheExamplesIsTheScaleParameter) {
  for (const char* quantity :
       {"Exo-glove: B10, mean, B90 (cycles)", "SDM hand: B10, mean, B90 (cycles)"}) {
    const std::vector<double> printed = row(quantity).paper;
    ASSERT_EQ(printed.size(), 3U);
    EXPECT_NEAR(printed[0], printed[1] * std::pow(-std::log(0.9), 1 / 5.94), 6.0);
    EXPECT_NEAR(printed[2], printed[1] * std::pow(-std::log(0.1), 1 / 5.94), 6.0);
  }
}

TEST(Paper, SdmHand) {
  expect_ours("SDM hand: T_in mean, amplitude (N)", {24.47, 24.47}, 0.006);
  expect_ours("SDM hand: T_eff (N)", {24.948}, 0.0006);
  expect_ours("SDM hand: B10, mean, B90 (cycles)", {1236.7, 1674.8, 2078.6}, 0.06);
}

TEST(Paper, MinerExample) {
  expect_ours("40 and 50 N in equal parts: average of lives (N)", {44.34}, 0.005);
  expect_ours("40 and 50 N in equal parts: average of damage (N)", {45.11}, 0.005);
}

TEST(Paper, TheReadmeShowsWhatIsComputed) {
  std::ifstream in(TENDONLIFE_README);
  if (!in) {
    GTEST_SKIP() << "NOT CHECKED: there is no " << TENDONLIFE_README;
  }
  const std::string readme{std::istreambuf_iterator<char>(in), {}};
  for (const std::string& fault : faults_of_paper_table(readme, "paper-table", paper_rows())) {
    ADD_FAILURE() << fault;
  }
}

}  // namespace
}  // namespace host_sim::reference::testing
