#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "host_sim/io/text_place.hpp"

namespace host_sim::monitor {

/// The words of a line, one after the other.
class AscWords {
 public:
  /// `line` outlives the words.
  explicit AscWords(const TextPlace& line);

  /// The word `ahead` of the next one; empty past the end.
  [[nodiscard]] std::string_view peek(std::size_t ahead = 0) const;
  /// Whether the next word is this one, in capitals or not; it is then taken.
  bool take(std::string_view word);
  /// The next word, which is `what` for the error where there is none. @throws InputError
  std::string_view demand(std::string_view accepted);
  /// A number from 0 to `largest` to `base`. @throws InputError
  std::uint32_t number(int base, std::uint32_t largest, std::string_view accepted);
  /// A word that number() would take, without an error.
  [[nodiscard]] bool is_number(std::size_t ahead, int base) const;
  void skip() { ++at_; }
  /// @throws InputError for the word taken last
  [[noreturn]] void refuse(std::string_view accepted) const;

 private:
  [[noreturn]] void fail(std::size_t at, std::string_view accepted) const;

  const TextPlace& line_;
  std::vector<std::string_view> words_;
  std::size_t at_ = 0;
};

/// The number in `word` to `base`, all of it.
std::optional<std::uint64_t> number_of(std::string_view word, int base);

/// Whether two texts are the same but for capital letters.
bool same_word(std::string_view one, std::string_view other);

}  // namespace host_sim::monitor
