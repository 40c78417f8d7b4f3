#pragma once

#include <string>
#include <vector>

#include "host_sim/campaign/campaign.hpp"

namespace host_sim::test {

/// Lives at even probabilities of a Weibull distribution: (i - 0.5) / n for i = 1 .. n.
std::vector<double> even_lives(double scale, double shape, std::size_t n);

/// A campaign without file, built a level at a time.
class CampaignBuilder {
 public:
  /// Failed specimens, one for each life.
  CampaignBuilder& level(double effective_tension_N, const std::vector<double>& lives,
                         Campaign::Role role = Campaign::Role::fit);
  CampaignBuilder& suspended(double effective_tension_N, const std::vector<double>& cycles);
  CampaignBuilder& specimen(const std::vector<std::pair<double, double>>& tension_N_and_cycles,
                            Campaign::Status status = Campaign::Status::failed,
                            Campaign::Role role = Campaign::Role::fit);
  CampaignBuilder& use(const std::string& name, double effective_tension_N);

  [[nodiscard]] const Campaign& campaign() const { return campaign_; }

 private:
  Campaign campaign_{"built", "built", {}, false, {}, {}, {}};
};

}  // namespace host_sim::test
