#include "tests/calibrate/campaigns.hpp"

#include <cmath>

namespace host_sim::test {
namespace {

Campaign::Load load_of(double effective_tension_N) {
  Campaign::Load load;
  load.input_tension_amplitude_N = effective_tension_N;
  load.effective_tension_N = effective_tension_N;
  return load;
}

}  // namespace

std::vector<double> even_lives(double scale, double shape, std::size_t n) {
  std::vector<double> lives;
  for (std::size_t i = 0; i < n; ++i) {
    const double p = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    lives.push_back(scale * std::pow(-std::log1p(-p), 1 / shape));
  }
  return lives;
}

CampaignBuilder& CampaignBuilder::specimen(
    const std::vector<std::pair<double, double>>& tension_N_and_cycles, Campaign::Status status,
    Campaign::Role role) {
  Campaign::Specimen made;
  made.line = campaign_.specimens.size() + 2;
  made.name = std::to_string(made.line);
  made.status = status;
  made.role = role;
  for (const auto& [tension_N, cycles] : tension_N_and_cycles) {
    made.blocks.push_back({load_of(tension_N), cycles, made.line});
  }
  campaign_.specimens.push_back(made);
  return *this;
}

CampaignBuilder& CampaignBuilder::level(double effective_tension_N,
                                        const std::vector<double>& lives, Campaign::Role role) {
  for (const double life : lives) {
    specimen({{effective_tension_N, life}}, Campaign::Status::failed, role);
  }
  return *this;
}

CampaignBuilder& CampaignBuilder::suspended(double effective_tension_N,
                                            const std::vector<double>& cycles) {
  for (const double life : cycles) {
    specimen({{effective_tension_N, life}}, Campaign::Status::suspended);
  }
  return *this;
}

CampaignBuilder& CampaignBuilder::use(const std::string& name, double effective_tension_N) {
  campaign_.uses.push_back({name, {{load_of(effective_tension_N), 1}}});
  return *this;
}

}  // namespace host_sim::test
