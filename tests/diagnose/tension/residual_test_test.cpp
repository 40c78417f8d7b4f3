#include "host_sim/diagnose/tension/residual_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/diagnose/tension/noisy_sessions.hpp"

namespace host_sim::diagnose::testing {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Six short sessions, looked at against what varies within them and what differs between them.
std::vector<Run> six_runs() {
  std::vector<Run> runs = small_design();
  std::vector<Run> six;
  for (std::size_t i = 0; i < runs.size(); i += 2) {
    six.push_back(runs[i]);
    six.back().duration_s = 3;
  }
  return six;
}

/// Columns of sessions of a design, for whose responses anything may be put.
class Design {
 public:
  explicit Design(std::vector<Component> model = {}) : sessions_(sessions_of(six_runs())) {
    GramOptions options = evidence_of(sessions_, kSample_sd).options;
    options.wanted = wanted_of(model);
    for (const Probe& probe : probes_of(sessions_)) {
      if (probe.of == Probe::Of::speed || probe.of == Probe::Of::sheath_temperature ||
          probe.of == Probe::Of::position) {
        options.probes.push_back(probe);
      }
    }
    grams_ = gram_of(sessions_, options);
    for (const Session& session : sessions_) {
      columns_.push_back(columns_of(session, grams_.layout, grams_.baseline));
    }
  }

  /// Noise and scatter of this seed, and `more` of each sample.
  [[nodiscard]] Grams responding(std::uint64_t seed,
                                 const std::function<double(const recording::Covariates&,
                                                            std::size_t)>& more = nullptr) const {
    Grams grams = grams_;
    statistics::Random random(seed, 1, 0);
    for (std::size_t s = 0; s < columns_.size(); ++s) {
      VectorXd response =
          0.02 * normal(random) * columns_[s].col(0) + 0.006 * normal(random) * columns_[s].col(1);
      for (Index i = 0; i < response.size(); ++i) {
        const auto sample = static_cast<std::size_t>(i);
        response(i) +=
            kSample_sd * normal(random) + (more ? more(sessions_[s].covariates, sample) : 0.0);
      }
      MatrixXd& gram = grams.sessions[s].gram;
      const Index last = grams.response();
      gram.col(last).head(last) = columns_[s].leftCols(last).transpose() * response;
      gram.row(last) = gram.col(last).transpose();
      gram(last, last) = response.squaredNorm();
    }
    return grams;
  }

 private:
  std::vector<Session> sessions_;
  Grams grams_;
  std::vector<MatrixXd> columns_;
};

const ProbeResult& of(const ResidualTest& test, Probe::Of what) {
  return *std::ranges::find(test.probes, what, &ProbeResult::of);
}

/// The largest distance of the distribution of p from a uniform one (Kolmogorov).
double distance_from_uniform(std::vector<double> p) {
  std::ranges::sort(p);
  double distance = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto count = static_cast<double>(p.size());
    distance = std::max({distance, p[i] - static_cast<double>(i) / count,
                         static_cast<double>(i + 1) / count - p[i]});
  }
  return distance;
}

TEST(ResidualTest, PIsUniformWhereNothingIsHidden) {
  const Design design;
  constexpr std::size_t kCampaigns = 100;
  std::vector<double> p;
  for (std::size_t i = 0; i < kCampaigns; ++i) {
    p.push_back(test_residual(design.responding(i), kSample_sd, 1, 0).p);
  }
  // Kolmogorov's 1 % point of 100 values.
  EXPECT_LT(distance_from_uniform(p), 1.63 / std::sqrt(kCampaigns));
}

double against_position(const recording::Covariates& c, std::size_t i) {
  return 0.01 * std::sin(200 * c.position_m[i]);
}

TEST(ResidualTest, FindsWhatIsHiddenWhereItIs) {
  const Design design;
  const ResidualTest test = test_residual(design.responding(1, against_position), kSample_sd, 1, 0);
  ASSERT_EQ(test.probes.size(), 3U);
  EXPECT_LE(test.p, 0.002);
  EXPECT_LE(of(test, Probe::Of::position).p, 0.002);
  EXPECT_GT(of(test, Probe::Of::sheath_temperature).p, 0.05);
  EXPECT_GT(of(test, Probe::Of::position).statistic, 2 * of(test, Probe::Of::speed).statistic);
  EXPECT_DOUBLE_EQ(test.excess,
                   of(test, Probe::Of::position).statistic - of(test, Probe::Of::position).freedom);
}

TEST(ResidualTest, TakesWhatDiffersBetweenSessionsForScatter) {
  const Design design;
  const auto by_session = [](const recording::Covariates& c, std::size_t) {
    return c.sheath_temperature_C.front() > 30 ? 0.03 : 0.0;
  };
  const ResidualTest test = test_residual(design.responding(1, by_session), kSample_sd, 1, 0);
  EXPECT_GT(of(test, Probe::Of::sheath_temperature).p, 0.01);
}

TEST(ResidualTest, OfTheRightModelFindsNothingAndSaysWhatItExplains) {
  const Design design({component("friction_temperature")});
  const auto heated = [](const recording::Covariates& c, std::size_t i) {
    return -kMu * 0.02 * (c.sheath_temperature_C[i] - 20) * c.bend_angle_rad[i] * c.direction[i];
  };
  const ResidualTest right = test_residual(design.responding(2, heated), kSample_sd, 1, 0);
  EXPECT_GT(right.p, 0.05);
  EXPECT_GT(right.explained, 30);
  EXPECT_LT(test_residual(design.responding(2), kSample_sd, 1, 0).explained, 10);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const double with = test_residual(design.responding(seed, heated), kSample_sd, 1, 0).p;
    EXPECT_LT(test_residual(Design().responding(seed, heated), kSample_sd, 1, 0).p, with) << seed;
  }
}

TEST(ResidualTest, IsTheSameForAnyNumberOfThreads) {
  const Grams grams = Design().responding(3, against_position);
  const ResidualTest one = test_residual(grams, kSample_sd, 9, 1);
  const ResidualTest three = test_residual(grams, kSample_sd, 9, 3);
  for (std::size_t i = 0; i < one.probes.size(); ++i) {
    EXPECT_EQ(one.probes[i].p, three.probes[i].p);
  }
}

TEST(ResidualTest, WithoutProbesSaysNothing) {
  Evidence evidence;
  const std::vector<Session> sessions = sessions_of(six_runs());
  evidence.sessions = sessions;
  evidence.options.wanted.clear();
  evidence.sample_sd = kSample_sd;
  const ResidualTest test = ResidualTests({}, 1).of(evidence, {});
  EXPECT_TRUE(test.probes.empty());
  EXPECT_EQ(test.p, 1);
}

}  // namespace
}  // namespace host_sim::diagnose::testing
