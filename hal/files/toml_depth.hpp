#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace hal::files {

/// Levels of keys and of places in arrays on the way to a value: `a.b = [1]` has three.
inline constexpr std::size_t kMostTomlDepth = 32;

/// Goes through TOML before it is parsed: a parser takes stack for each level.
class TomlDepth {
 public:
  /// From 1, the column in characters.
  struct TextPosition {
    std::uint32_t line;
    std::uint32_t column;
  };

  explicit constexpr TomlDepth(std::string_view text) : text_(text) {}

  /// Where the text first goes deeper than kMostTomlDepth. It ends with what is no TOML, as a
  /// parser does.
  constexpr std::optional<TextPosition> first_too_deep() {
    while (at_ < text_.size()) {
      if (!take()) {
        return level_ > kMostTomlDepth ? std::optional(place()) : std::nullopt;
      }
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] constexpr TextPosition place() const {
    TextPosition place{1, 1};
    for (const char c : text_.substr(0, at_)) {
      const bool continues = (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
      place = c == '\n' ? TextPosition{place.line + 1, 1}
                        : TextPosition{place.line, place.column + (continues ? 0U : 1U)};
    }
    return place;
  }

  enum class TomlPart { header, key, value };

  /// An array or inline table that is open.
  struct Open {
    char closed_by;
    std::size_t level;  ///< of itself
  };

  /// Goes past a character or a string; false where the text is too deep or no TOML.
  constexpr bool take() {
    switch (text_[at_]) {
      case '#':
        at_ = std::min(text_.find('\n', at_), text_.size());
        return true;
      case '"':
      case '\'':
        begin_key();
        return skip_string();
      case '\n':
        if (opened_ == 0) {
          part_ = TomlPart::key;
          in_key_ = false;
          level_ = table_;
        }
        break;
      case '[':
        if (part_ == TomlPart::value) {
          if (!open(']')) {
            return false;
          }
          ++level_;
        } else {
          table_ = part_ == TomlPart::header ? table_ + 1 : 1;
          part_ = TomlPart::header;
          level_ = table_;
        }
        break;
      case '{':
        if (part_ != TomlPart::value || !open('}')) {
          return false;
        }
        part_ = TomlPart::key;
        in_key_ = false;
        break;
      case ']':
        if (part_ == TomlPart::header) {
          break;
        }
        [[fallthrough]];
      case '}':
        if (opened_ == 0 || open_[opened_ - 1].closed_by != text_[at_]) {
          return false;
        }
        level_ = open_[--opened_].level;
        part_ = TomlPart::value;
        break;
      case ',':
        if (opened_ == 0) {
          return false;
        }
        level_ = open_[opened_ - 1].level;
        part_ = open_[opened_ - 1].closed_by == ']' ? TomlPart::value : TomlPart::key;
        in_key_ = false;
        level_ += part_ == TomlPart::value ? 1 : 0;
        break;
      case '.':
        level_ += part_ == TomlPart::value ? 0 : 1;
        table_ += part_ == TomlPart::header ? 1 : 0;
        break;
      case '=':
        part_ = TomlPart::value;
        break;
      case ' ':
      case '\t':
      case '\r':
        break;
      default:
        begin_key();
        break;
    }
    if (level_ > kMostTomlDepth) {
      return false;
    }
    ++at_;
    return true;
  }

  constexpr void begin_key() {
    if (part_ == TomlPart::key && !in_key_) {
      in_key_ = true;
      ++level_;
    }
  }

  constexpr bool open(char closed_by) {
    if (opened_ == open_.size()) {
      level_ = kMostTomlDepth + 1;
      return false;
    }
    open_[opened_++] = {closed_by, level_};
    return true;
  }

  /// False where it does not end.
  constexpr bool skip_string() {
    const char quote = text_[at_];
    std::size_t quotes = 0;
    while (at_ < text_.size() && text_[at_] == quote && quotes < 3) {
      ++quotes;
      ++at_;
    }
    if (quotes == 2) {
      return level_ <= kMostTomlDepth;
    }
    const std::size_t wanted = quotes;
    for (quotes = 0; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      quotes = c == quote ? quotes + 1 : 0;
      if (quotes == wanted) {
        ++at_;
        break;
      }
      if (c == '\n' && wanted == 1) {
        return false;
      }
      at_ += c == '\\' && quote == '"' ? 1 : 0;
    }
    // Up to two more may stand before those that end it.
    for (int more = 0; wanted == 3 && more < 2 && at_ < text_.size() && text_[at_] == quote;
         ++more) {
      ++at_;
    }
    return level_ <= kMostTomlDepth;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  TomlPart part_ = TomlPart::key;
  bool in_key_ = false;
  std::size_t level_ = 0;  ///< of what is read
  std::size_t table_ = 0;  ///< of the table whose keys follow
  std::array<Open, kMostTomlDepth> open_{};
  std::size_t opened_ = 0;
};

}  // namespace hal::files
