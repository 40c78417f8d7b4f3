#include "host_sim/synth/campaign/campaign_text.hpp"

#include <fmt/format.h>

#include <iterator>

#include "host_sim/io/model_keys.hpp"

namespace host_sim::synth {
namespace {

/// A text of visible characters as a TOML string.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
    }
    result += c;
  }
  result += '"';
  return result;
}

bool has_table(const SynthPlan& plan, std::string_view table) {
  return (table == "cable" && plan.cable) || (table == "sheath" && plan.sheath) ||
         (table == "drive" && plan.drive) || (table == "counting" && plan.counting) ||
         (table == "life" && plan.life);
}

Model model_of(const SynthPlan& plan) {
  Model model{};
  if (plan.cable) {
    model.cable = *plan.cable;
  }
  if (plan.sheath) {
    model.sheath = *plan.sheath;
  }
  if (plan.drive) {
    model.drive = *plan.drive;
  }
  if (plan.counting) {
    model.counting = *plan.counting;
  }
  if (plan.life) {
    model.life = *plan.life;
  }
  return model;
}

}  // namespace

std::string campaign_text(const SynthPlan& plan) {
  Model model = model_of(plan);
  std::string text = fmt::format("schema = 1\n\n[campaign]\nname = {}\n", quoted(plan.name));
  std::string_view table;
  for (const ModelKey& key : model_keys()) {
    if (!has_table(plan, key.table)) {
      continue;
    }
    if (table != key.table) {
      table = key.table;
      fmt::format_to(std::back_inserter(text), "\n[model.{}]\n", table);
      text += table == "life" ? "mean_stress = \"gerber\"\n" : "";
    }
    fmt::format_to(std::back_inserter(text), "{} = {}\n", key.key, key.value(model));
  }
  return text;
}

}  // namespace host_sim::synth
