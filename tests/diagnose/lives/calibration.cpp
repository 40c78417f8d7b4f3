// Fits what turns the evidence of lives into probabilities:
//   lives_calibration EVIDENCE...
// EVIDENCE is what lives_evidence wrote. Prints the constants of calibration.cpp, by the largest
// sum of the log score of the truth, and how the scores come out with them and with those in use.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "host_sim/diagnose/lives/decision.hpp"
#include "host_sim/diagnose/lives/maximize.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::test {
namespace {

using namespace host_sim::diagnose;
using namespace host_sim::diagnose::lives;

struct Weighed {
  std::string truth;
  std::vector<Hypothesis> hypotheses;
};

std::vector<std::string> parts_of(const std::string& id) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= id.size();) {
    const std::size_t end = std::min(id.find('+', begin), id.size());
    parts.push_back(id.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

void read(const std::string& path, std::map<std::size_t, Weighed>& campaigns) {
  std::ifstream file(path);
  std::size_t seed = 0;
  std::size_t effects = 0;
  std::size_t specimens = 0;
  std::string truth;
  std::string id;
  int outside = 0;
  double log_evidence = 0;
  double log_likelihood = 0;
  while (file >> seed >> truth >> specimens >> id >> effects >> outside >> log_evidence >>
         log_likelihood) {
    Hypothesis hypothesis;
    hypothesis.outside = outside == 1;
    hypothesis.log_evidence = log_evidence;
    if (effects > 0 || hypothesis.outside) {
      hypothesis.effects = parts_of(id);
    }
    campaigns[seed].truth = truth;
    campaigns[seed].hypotheses.push_back(std::move(hypothesis));
  }
}

std::vector<Candidate> candidates(Weighed campaign, const Calibration& calibration) {
  calibrate(campaign.hypotheses, calibration);
  return candidates_of(campaign.hypotheses);
}

/// Of the truth; one that was not tried has a share of what is always left for surprises.
double log_score(const Weighed& campaign, const Calibration& calibration) {
  constexpr double kSurprise = 1e-4;
  const std::vector<Candidate> all = candidates(campaign, calibration);
  const auto truth = std::ranges::find(all, campaign.truth, &Candidate::id);
  return std::log((1 - kSurprise) * (truth == all.end() ? 0 : truth->probability) +
                  kSurprise / static_cast<double>(all.size()));
}

double sum_of_scores(const std::vector<Weighed>& campaigns, const Calibration& calibration) {
  std::vector<double> scores(campaigns.size());
  statistics::parallel_for(
      scores.size(), [&](std::size_t i) { scores[i] = log_score(campaigns[i], calibration); });
  double sum = 0;
  for (const double score : scores) {
    sum += score;
  }
  return sum;
}

Calibration calibration_at(const Eigen::VectorXd& at) {
  Calibration made{std::exp(at[0]), at[1], at[2], at[3], calibration().ln_weights};
  Eigen::Index next = 4;
  for (auto& [effect, ln_weight] : made.ln_weights) {
    ln_weight = at[next++];
  }
  return made;
}

/// Weights of effects are normal about 0 with a standard deviation of 1.
Calibration best_of(const std::vector<Weighed>& campaigns) {
  const auto weights = static_cast<Eigen::Index>(calibration().ln_weights.size());
  const auto score = [&](const Eigen::VectorXd& at) {
    return sum_of_scores(campaigns, calibration_at(at)) - at.tail(weights).squaredNorm() / 2;
  };
  return calibration_at(maximize(score, Eigen::VectorXd::Zero(4 + weights)));
}

void print(const char* name, const Calibration& used, const std::vector<Weighed>& campaigns) {
  fmt::print("{}: power {:.2f}, single {:.2f}, pair {:.2f}, outside {:.2f}", name, used.power,
             used.ln_single, used.ln_pair, used.ln_outside);
  for (const auto& [effect, ln_weight] : used.ln_weights) {
    fmt::print(", {} {:.2f}", effect, ln_weight);
  }
  double right = 0;
  double covered = 0;
  double size = 0;
  for (const Weighed& campaign : campaigns) {
    const std::vector<Candidate> all = candidates(campaign, used);
    const std::vector<std::string> set = credible_set_of(all);
    right += all.front().id == campaign.truth ? 1 : 0;
    covered += std::ranges::find(set, campaign.truth) != set.end() ? 1 : 0;
    size += static_cast<double>(set.size());
  }
  const auto n = static_cast<double>(campaigns.size());
  fmt::print("\n  {} campaigns: log score {:.4f}, first {:.3f}, covered {:.3f}, set {:.2f}\n",
             campaigns.size(), sum_of_scores(campaigns, used) / n, right / n, covered / n,
             size / n);
}

void run(std::span<char*> arguments) {
  std::map<std::size_t, Weighed> read_ones;
  for (const char* path : arguments.subspan(1)) {
    read(path, read_ones);
  }
  std::vector<Weighed> campaigns;
  for (auto& [seed, campaign] : read_ones) {
    campaigns.push_back(std::move(campaign));
  }
  print("in use", calibration(), campaigns);
  print("best", best_of(campaigns), campaigns);
}

}  // namespace
}  // namespace host_sim::test

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "lives_calibration EVIDENCE...\n");
    return 2;
  }
  try {
    host_sim::test::run(std::span(argv, static_cast<std::size_t>(argc)));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
