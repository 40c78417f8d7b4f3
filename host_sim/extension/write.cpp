#include "host_sim/extension/write.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "host_sim/extension/keys.hpp"

namespace host_sim {
namespace {

/// The shortest text that reads as this number, and as a float.
std::string number_text(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) {
    text += ".0";
  }
  return text;
}

/// Whether a name stands for an array even where it holds one number.
bool is_array(const Extension& extension, const Extension::Value& value) {
  if (value.name == kBendAngles.name || value.values.size() > 1) {
    return true;
  }
  for (const Extension::Value& other : extension.values) {
    if (other.name == kBendAngles.name) {
      return true;
    }
  }
  return false;
}

std::string value_text(const Extension& extension, const Extension::Value& value) {
  if (!is_array(extension, value)) {
    return number_text(value.values.front());
  }
  std::vector<std::string> numbers;
  for (const double number : value.values) {
    numbers.push_back(number_text(number));
  }
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

}  // namespace

std::string toml_text(std::span<const Extension> extensions) {
  std::string text;
  for (const Extension& extension : extensions) {
    text += fmt::format("{}[extension.{}]\n", text.empty() ? "" : "\n", extension.id);
    for (const Extension::Value& value : extension.values) {
      text += fmt::format("{} = {}\n", value.name, value_text(extension, value));
    }
  }
  return text;
}

}  // namespace host_sim
