#include "host_sim/diagnose/probe.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/diagnose/audit/sessions.hpp"

namespace host_sim::diagnose {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// One session that holds a cycle number and little else.
Session session_with_cycles(std::vector<double> cycles) {
  Session session{.name = "s", .covariates = {}};
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    session.covariates.time_s.push_back(5);
    session.covariates.direction.push_back(i % 2 == 0 ? 1 : -1);
  }
  session.covariates.cycle = std::move(cycles);
  return session;
}

const Probe& cycles_in(const std::vector<Probe>& probes) {
  return *std::ranges::find(probes, Probe::Of::cycle, &Probe::of);
}

TEST(Probe, HasBinsOfLikeNumbersOfSamples) {
  std::vector<double> cycles;
  for (int i = 12; i > 0; --i) {
    cycles.push_back(i * i);
  }
  const std::vector<Session> sessions{session_with_cycles(cycles)};
  // Of 1, 4, 9 .. 144 every second one is a quantile; edges are halfway from it to the next.
  EXPECT_THAT(cycles_in(probes_of(sessions)).edges, ElementsAre(12.5, 30.5, 56.5, 90.5, 132.5));
}

TEST(Probe, SplitsFewValuesHalfwayBetweenThem) {
  const std::vector<Session> sessions{session_with_cycles({0, 0, 0, 0, 10, 10}),
                                      session_with_cycles({10, 10, 40, 40, 40, 40})};
  const Probe probe = cycles_in(probes_of(sessions));
  EXPECT_THAT(probe.edges, ElementsAre(5, 25));
  EXPECT_EQ(probe.bins(), 3U);
  EXPECT_EQ(probe.columns(), 6U);
}

TEST(Probe, LeavesOutWhatDoesNotVaryOrWasNotRecorded) {
  std::vector<Session> sessions{session_with_cycles({3, 3, 3, 3})};
  EXPECT_THAT(probes_of(sessions), IsEmpty());
  sessions.push_back(session_with_cycles({7, 7}));
  EXPECT_EQ(probes_of(sessions).size(), 1U);
  sessions[1].covariates.cycle.clear();
  EXPECT_THAT(probes_of(sessions), IsEmpty());
}

TEST(Probe, PutsASampleInTheBinOfItsValueAndDirection) {
  const Probe probe{.of = Probe::Of::cycle, .edges = {5, 25}};
  Session session = session_with_cycles({0, 5, 4.9, 24, 25, 100});
  // Even samples pull, odd ones let go; a value at an edge is above it.
  EXPECT_THAT(probe.column_of(session.covariates), ElementsAre(3, 1, 3, 1, 5, 2));
}

TEST(Probe, ValuesAreThoseOfTheCovariate) {
  recording::Covariates c;
  c.time_s = {7, 9};
  c.direction = {-1, 1};
  c.velocity_m_s = {-0.25, 0.5};
  c.input_tension_N = {8, 4};
  c.output_tension_N = {2, 9};
  c.motor_angle_rad = {-1, 7};
  EXPECT_THAT(values_of(Probe::Of::speed, c), ElementsAre(0.25, 0.5));
  EXPECT_THAT(values_of(Probe::Of::elapsed, c), ElementsAre(0, 2));
  const auto log_tension = values_of(Probe::Of::log_tension, c);
  EXPECT_NEAR(log_tension[0], std::log(4.0), 1e-15);
  EXPECT_NEAR(log_tension[1], std::log(6.0), 1e-15);
  const auto angle = values_of(Probe::Of::motor_angle, c);
  EXPECT_NEAR(angle[0], 6.283185307179586 - 1, 1e-14);
  EXPECT_NEAR(angle[1], 7 - 6.283185307179586, 1e-14);
  EXPECT_THAT(values_of(Probe::Of::sheath_temperature, c), IsEmpty());
}

TEST(Probe, OfAWholeDesignSeesAllThatVariesAndSharesTheSamples) {
  const std::vector<Session> sessions = testing::sessions_of(testing::crossed());
  const std::vector<Probe> probes = probes_of(sessions);
  EXPECT_EQ(probes.size(), 11U);
  for (const Probe& probe : probes) {
    EXPECT_FALSE(name_of(probe.of).empty());
    EXPECT_FALSE(unit_of(probe.of).empty());
    EXPECT_TRUE(std::ranges::is_sorted(probe.edges));
    std::vector<double> counts(probe.columns());
    double samples = 0;
    for (const Session& session : sessions) {
      for (const std::size_t column : probe.column_of(session.covariates)) {
        counts.at(column) += 1;
        samples += 1;
      }
    }
    if (probe.of == Probe::Of::elapsed) {
      for (std::size_t bin = 0; bin < probe.bins(); ++bin) {
        EXPECT_NEAR((counts[bin] + counts[probe.bins() + bin]) / samples, 1.0 / 6, 0.01);
      }
    }
  }
}

}  // namespace
}  // namespace host_sim::diagnose
