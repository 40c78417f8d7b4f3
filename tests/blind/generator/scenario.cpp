#include "tests/blind/generator/scenario.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace blind {

std::string_view name_of(CampaignKind kind) {
  switch (kind) {
    case CampaignKind::none:
      return "none";
    case CampaignKind::one:
      return "one";
    case CampaignKind::two:
      return "two";
    case CampaignKind::three:
      return "three";
    case CampaignKind::outside:
      return "outside";
  }
  return "";
}

std::string_view name_of(Design design) {
  switch (design) {
    case Design::crossed:
      return "crossed";
    case Design::one_pose:
      return "one_pose";
    case Design::two_sided:
      return "two_sided";
  }
  return "";
}

std::string_view name_of(Input input) {
  return input == Input::load_cell ? "load_cell" : "motor_current";
}

std::string_view name_of(Data data) {
  return data == Data::recordings ? "recordings" : "lives";
}

std::string table(std::string_view name) {
  return fmt::format("\n[{}]\n", name);
}

std::string line(std::string_view key, double value) {
  return fmt::format("{} = {}\n", key, value);
}

std::string line(std::string_view key, const std::vector<double>& values) {
  return fmt::format("{} = [{}]\n", key, fmt::join(values, ", "));
}

std::string line(std::string_view key, std::string_view word) {
  return fmt::format("{} = \"{}\"\n", key, word);
}

std::string line(std::string_view key, const std::vector<std::string>& texts) {
  return fmt::format("{} = [\"{}\"]\n", key, fmt::join(texts, "\", \""));
}

std::string table_of(const HiddenEffect& effect) {
  std::string text = table((effect.outside ? "outside." : "effects.") + effect.id);
  for (const auto& [key, values] : effect.numbers) {
    text += values.size() == 1 ? line(key, values.front()) : line(key, values);
  }
  for (const auto& [key, word] : effect.texts) {
    text += line(key, std::string_view(word));
  }
  return text;
}

}  // namespace blind
