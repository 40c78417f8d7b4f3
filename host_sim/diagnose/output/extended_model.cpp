#include "host_sim/diagnose/output/extended_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "hal/files/text.hpp"
#include "host_sim/campaign/nominal_model.hpp"
#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/extension/model_file.hpp"
#include "host_sim/recording/recording.hpp"

namespace host_sim::diagnose {

using hal::files::kInputTensionColumn;
using hal::files::printable;

namespace {

constexpr double kMostEfficient = 1;

/// Tension is torque constant times efficiency times what stays as it is.
void apply_gain(Model::Drive& drive, double gain) {
  const double wanted = drive.gear_efficiency * gain;
  drive.gear_efficiency = std::min(wanted, kMostEfficient);
  drive.torque_constant_Nm_per_A *= wanted / drive.gear_efficiency;
}

Model refitted_model(const Campaign& campaign, const Diagnosis& diagnosis, InputFrom input) {
  const NominalModel& nominal = campaign.nominal;
  Model model{*nominal.cable, *nominal.sheath, nominal.drive, *nominal.counting, {}, {},
              nominal.watch};
  if (nominal.life) {
    model.life = *nominal.life;
  }
  if (diagnosis.tension) {
    model.sheath.friction_coefficient = diagnosis.tension->friction_coefficient;
    if (model.drive && input == InputFrom::current) {
      apply_gain(*model.drive, std::exp(diagnosis.tension->log_gain));
    }
  }
  if (diagnosis.lives) {
    const LifeDiagnosis& lives = *diagnosis.lives;
    model.life = {Model::MeanStress::kGerber, lives.ipl_scale, lives.ipl_exponent,
                  lives.weibull_shape};
  }
  return model;
}

/// Not what is wrong with the rig alone, as the zero of its load cell is.
bool is_in_model(const Extension& extension) {
  return extension_keys(extension.id) != nullptr;
}

std::string head(const Campaign& campaign, const Diagnosis& diagnosis, InputFrom input,
                 std::string_view program_version) {
  std::string text = fmt::format("# Written by host_sim diagnose {} from the campaign {}.\n",
                                 program_version, printable(campaign.name));
  if (diagnosis.tension) {
    const bool drive = campaign.nominal.drive && input == InputFrom::current;
    text += fmt::format("# [sheath] friction_coefficient{} refitted from the recordings.\n",
                        drive ? " and the gain of [drive]" : "");
  }
  if (diagnosis.lives) {
    text += "# [life] refitted from the lives.\n";
  }
  for (const DataFindings& part : findings_by_data(diagnosis)) {
    text += fmt::format("# Verdict on the {}: {}.\n", part.name, name_of(part.findings->verdict));
    for (const Extension& extension : part.findings->extensions) {
      text += extension.id == kEmpirical
                  ? "# A correction besides, whose cause is not known: empirical.\n"
                  : fmt::format("# {} {}.\n",
                                is_in_model(extension) ? "Extended by" : "Outside of the model:",
                                printable(extension.id));
    }
  }
  return text + "schema = 1\n";
}

}  // namespace

void require_extensible_model(const Campaign& campaign) {
  require_nominal_model(campaign);
  if (campaign.specimens.empty()) {
    require_nominal_life(campaign);
  }
}

InputFrom input_of(const Campaign& campaign) {
  const auto recordings = recording::read_recordings(campaign.folder, campaign.columns);
  const bool current =
      std::any_of(recordings.begin(), recordings.end(),
                  [](const recording::Recording& one) { return !one.has(kInputTensionColumn); });
  return current ? InputFrom::current : InputFrom::load_cell;
}

std::string extended_model_text(const Campaign& campaign, const Diagnosis& diagnosis,
                                InputFrom input, std::string_view program_version) {
  std::string text = head(campaign, diagnosis, input, program_version) +
                     model_tables(campaign, refitted_model(campaign, diagnosis, input), "refitted");
  std::vector<Extension> extensions = merged(diagnosis).extensions;
  std::erase_if(extensions, std::not_fn(is_in_model));
  if (!extensions.empty()) {
    text += "\n" + toml_text(extensions);
    // What reads it has the bounds.
    parse_extended_model(text, fmt::format("the extended model of {}", printable(campaign.name)));
  }
  return text;
}

}  // namespace host_sim::diagnose
