#include "tests/blind/generator/scenario.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace blind {

std::string_view word_of(Kind kind) {
  switch (kind) {
    case Kind::none:
      return "none";
    case Kind::one:
      return "one";
    case Kind::two:
      return "two";
    case Kind::outside:
      return "outside";
  }
  return "";
}

std::string_view word_of(Design design) {
  return design == Design::crossed ? "crossed" : "one_pose";
}

std::string_view word_of(Input input) {
  return input == Input::load_cell ? "load_cell" : "motor_current";
}

std::string_view word_of(Data data) {
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
