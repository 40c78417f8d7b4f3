#include "hal/files/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

namespace hal::files {
namespace {

constexpr std::size_t kQuotedLimit = 40;

struct Character {
  std::size_t bytes;
  char32_t code;  ///< kInvalid if the first byte starts no valid UTF-8 sequence
};

constexpr char32_t kInvalid = 0xFFFFFFFF;

std::uint8_t byte_at(std::string_view text, std::size_t index) {
  return static_cast<std::uint8_t>(text[index]);
}

// Table 3-7 of the Unicode Standard: shortest form only, no surrogates, at most U+10FFFF.
Character first_character(std::string_view text) {
  const std::uint8_t lead = byte_at(text, 0);
  if (lead < 0x80) {
    return {1, lead};
  }
  std::size_t bytes = 0;
  char32_t code = 0;
  char32_t smallest = 0;
  if ((lead & 0xE0) == 0xC0) {
    bytes = 2;
    code = lead & 0x1F;
    smallest = 0x80;
  } else if ((lead & 0xF0) == 0xE0) {
    bytes = 3;
    code = lead & 0x0F;
    smallest = 0x800;
  } else if ((lead & 0xF8) == 0xF0) {
    bytes = 4;
    code = lead & 0x07;
    smallest = 0x10000;
  }
  if (bytes == 0 || text.size() < bytes) {
    return {1, kInvalid};
  }
  for (std::size_t i = 1; i < bytes; ++i) {
    const std::uint8_t next = byte_at(text, i);
    if ((next & 0xC0) != 0x80) {
      return {1, kInvalid};
    }
    code = (code << 6) | (next & 0x3Fu);
  }
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < smallest || code > 0x10FFFF || surrogate) {
    return {1, kInvalid};
  }
  return {bytes, code};
}

bool is_shown_as_is(char32_t code) {
  struct Range {
    char32_t first, last;
  };
  static constexpr std::array<Range, 10> kHidden{{
      {0x00, 0x1F},      // C0 controls
      {0x7F, 0x9F},      // delete, C1 controls
      {0xAD, 0xAD},      // soft hyphen
      {0x61C, 0x61C},    // Arabic letter mark
      {0x200B, 0x200F},  // zero width, direction marks
      {0x2028, 0x202E},  // line and paragraph separators, direction overrides
      {0x2060, 0x206F},  // invisible operators, direction isolates
      {0xFEFF, 0xFEFF},  // byte order mark
      {0xFFF9, 0xFFFB},  // interlinear annotation
      {0xE0000, kInvalid},
  }};
  for (const Range& range : kHidden) {
    if (code >= range.first && code <= range.last) {
      return false;
    }
  }
  return true;
}

void append_escaped(std::string& out, std::string_view bytes) {
  for (const char c : bytes) {
    switch (c) {
      case '\n':
        out += "\\n";
        break;
      case '\r':
        out += "\\r";
        break;
      case '\t':
        out += "\\t";
        break;
      default:
        out += fmt::format("\\x{:02x}", static_cast<std::uint8_t>(c));
    }
  }
}

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

std::string printable(std::string_view text, std::size_t limit) {
  std::string out;
  std::size_t kept = 0;
  while (!text.empty()) {
    if (kept == limit) {
      out += "...";
      break;
    }
    const Character character = first_character(text);
    const std::string_view bytes = text.substr(0, character.bytes);
    if (is_shown_as_is(character.code)) {
      out += bytes;
    } else {
      append_escaped(out, bytes);
    }
    text.remove_prefix(character.bytes);
    ++kept;
  }
  return out;
}

std::string in_quotes(std::string_view text) {
  return fmt::format("'{}'", printable(text, kQuotedLimit));
}

std::size_t character_count(std::string_view text) {
  std::size_t count = 0;
  while (!text.empty()) {
    text.remove_prefix(first_character(text).bytes);
    ++count;
  }
  return count;
}

bool parse_number(const char*& position, const char* end, double& value) {
  const char* begin = position;
  if (end - begin > 1 && *begin == '+' && begin[1] != '-') {
    ++begin;
  }
  const std::from_chars_result result = std::from_chars(begin, end, value);
  if (result.ec != std::errc()) {
    return false;
  }
  position = result.ptr;
  return true;
}

std::optional<std::string_view> other_unit(std::string_view name, std::string_view known,
                                           std::string_view unit) {
  std::string_view stem = known;
  if (!unit.empty()) {
    stem.remove_suffix(unit.size() + 1);
  }
  if (name == known || !name.starts_with(stem)) {
    return std::nullopt;
  }
  name.remove_prefix(stem.size());
  if (name.empty()) {
    return name;
  }
  if (name.front() != '_' || !std::all_of(name.begin(), name.end(), is_name_character)) {
    return std::nullopt;
  }
  return name.substr(1);
}

bool NumberRange::contains(double value) const {
  return value <= maximum && (above_minimum ? value > minimum : value >= minimum);
}

std::string range_text(const NumberRange& range) {
  return range.above_minimum ? fmt::format("above {} up to {}", range.minimum, range.maximum)
                             : fmt::format("{}..{}", range.minimum, range.maximum);
}

}  // namespace hal::files
