#include "host_sim/monitor/bus/asc_words.hpp"

#include <algorithm>
#include <charconv>

namespace host_sim::monitor {
namespace {

constexpr std::string_view kSpace = " \t";

char small(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

std::optional<std::uint64_t> number_of(std::string_view word, int base) {
  std::uint64_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value, base);
  if (error != std::errc() || stop != end) {
    return std::nullopt;
  }
  return value;
}

bool same_word(std::string_view one, std::string_view other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](char a, char b) { return small(a) == small(b); });
}

AscWords::AscWords(const TextPlace& line) : line_(line) {
  std::size_t at = 0;
  while ((at = line.text.find_first_not_of(kSpace, at)) != std::string_view::npos) {
    const std::size_t end = std::min(line.text.find_first_of(kSpace, at), line.text.size());
    words_.push_back(line.text.substr(at, end - at));
    at = end;
  }
}

std::string_view AscWords::peek(std::size_t ahead) const {
  return at_ + ahead < words_.size() ? words_[at_ + ahead] : std::string_view();
}

bool AscWords::take(std::string_view word) {
  const bool found = same_word(peek(), word);
  at_ += found ? 1 : 0;
  return found;
}

std::string_view AscWords::demand(std::string_view accepted) {
  if (at_ >= words_.size()) {
    fail(at_, accepted);
  }
  return words_[at_++];
}

std::uint32_t AscWords::number(int base, std::uint32_t largest, std::string_view accepted) {
  const auto value = number_of(demand(accepted), base);
  if (!value || *value > largest) {
    refuse(accepted);
  }
  return static_cast<std::uint32_t>(*value);
}

bool AscWords::is_number(std::size_t ahead, int base) const {
  return number_of(peek(ahead), base).has_value();
}

void AscWords::refuse(std::string_view accepted) const {
  fail(at_ - 1, accepted);
}

void AscWords::fail(std::size_t at, std::string_view accepted) const {
  if (at >= words_.size()) {
    line_.fail(line_.text.size(), "the line ends", accepted);
  }
  const auto offset = static_cast<std::size_t>(words_[at].data() - line_.text.data());
  line_.fail(offset, in_quotes(words_[at].substr(0, 40)), accepted);
}

}  // namespace host_sim::monitor
