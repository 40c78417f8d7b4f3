#include "host_sim/synth/campaign/make.hpp"

#include "host_sim/io/output_file.hpp"
#include "host_sim/synth/campaign/campaign_text.hpp"
#include "host_sim/synth/campaign/lives.hpp"
#include "host_sim/synth/campaign/sessions.hpp"

namespace host_sim::synth {
Truth make_campaign(const SynthPlan& plan, const MakeOptions& options,
                    const std::filesystem::path& folder) {
  write_file(folder / "campaign.toml", campaign_text(plan));
  if (plan.lives) {
    const LifeTexts texts = life_texts(plan, options.seed);
    write_file(folder / "specimens.csv", texts.specimens);
    if (!texts.blocks.empty()) {
      write_file(folder / "blocks.csv", texts.blocks);
    }
  }
  return plan.recordings ? write_sessions(plan, options, folder) : Truth{};
}

}  // namespace host_sim::synth
