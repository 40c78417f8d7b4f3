#include "tests/blind/generator/toml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace blind {

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

std::string line(std::string_view key, const std::vector<std::string>& words) {
  return fmt::format("{} = [\"{}\"]\n", key, fmt::join(words, "\", \""));
}

std::string table_of(const HiddenEffect& effect) {
  std::string text = table((effect.outside ? "outside." : "effects.") + effect.id);
  for (const auto& [key, values] : effect.numbers) {
    text += values.size() == 1 ? line(key, values.front()) : line(key, values);
  }
  for (const auto& [key, word] : effect.words) {
    text += line(key, std::string_view(word));
  }
  return text;
}

}  // namespace blind
