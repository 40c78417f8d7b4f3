#include "host_sim/monitor/bus/asc_reader.hpp"

#include <algorithm>
#include <utility>

#include "host_sim/monitor/bus/asc_event.hpp"
#include "host_sim/monitor/bus/asc_words.hpp"

namespace host_sim::monitor {
namespace {

constexpr std::string_view kAcceptedLine =
    "a time in seconds and an event, a header (date, base, internal events logged, Begin and End "
    "Triggerblock), or a comment after //";
constexpr std::string_view kAcceptedTime = "seconds up to 1e9, with up to 9 decimals";
constexpr std::string_view kAcceptedBase = "base hex or dec, then timestamps absolute or relative";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Seconds as nanoseconds, or nothing.
std::optional<std::int64_t> time_of(std::string_view word) {
  const std::size_t dot = word.find('.');
  const std::string_view whole = word.substr(0, dot);
  const std::string_view fraction =
      dot == std::string_view::npos ? std::string_view() : word.substr(dot + 1);
  const auto seconds = number_of(whole, 10);
  const auto decimals =
      fraction.empty() ? std::optional<std::uint64_t>(0) : number_of(fraction, 10);
  if (!seconds || !decimals || *seconds > 1'000'000'000 || fraction.size() > 9) {
    return std::nullopt;
  }
  std::uint64_t nanoseconds = *decimals;
  for (std::size_t digit = fraction.size(); digit < 9; ++digit) {
    nanoseconds *= 10;
  }
  return static_cast<std::int64_t>(*seconds * 1'000'000'000 + nanoseconds);
}

bool is_header(const AscWords& words) {
  const std::string_view first = words.peek();
  const auto is = [&words](std::string_view a, std::string_view b) {
    return same_word(words.peek(), a) && same_word(words.peek(1), b);
  };
  return first.empty() || first.starts_with("//") || same_word(first, "date") ||
         is("internal", "events") || is("no", "internal") || is("begin", "triggerblock") ||
         is("end", "triggerblock");
}

}  // namespace

bool is_asc(std::string_view front) {
  const std::string_view text =
      front.substr(std::min(front.find_first_not_of(" \t\r\n"), front.size()));
  return same_word(text.substr(0, 5), "date ") || same_word(text.substr(0, 5), "base ") ||
         text.starts_with("//");
}

AscReader::AscReader(std::unique_ptr<ByteSource> source, std::string name)
    : name_(std::move(name)), lines_(std::move(source), name_) {}

std::optional<SeenFrame> AscReader::next() {
  while (lines_.fill()) {
    std::optional<SeenFrame> seen = take_line();
    lines_.next_line(lines_.line_end());
    if (seen) {
      return seen;
    }
  }
  return std::nullopt;
}

std::optional<SeenFrame> AscReader::take_line() {
  const TextPlace line{name_, lines_.line_number(), lines_.line()};
  AscWords words(line);
  if (words.take("base")) {
    format_.hexadecimal = words.take("hex");
    const bool sound = (format_.hexadecimal || words.take("dec")) && words.take("timestamps");
    format_.relative = words.take("relative");
    if (!sound || !(format_.relative || words.take("absolute"))) {
      words.demand(kAcceptedBase);
      words.refuse(kAcceptedBase);
    }
    return std::nullopt;
  }
  if (is_header(words)) {
    return std::nullopt;
  }
  const std::string_view word = words.demand(kAcceptedLine);
  if (!is_digit(word.front())) {
    words.refuse(kAcceptedLine);
  }
  const auto time_ns = time_of(word);
  if (!time_ns || (format_.relative && time_ns_ > std::int64_t{1} << 61)) {
    words.refuse(kAcceptedTime);
  }
  time_ns_ = format_.relative ? time_ns_ + *time_ns : *time_ns;
  std::optional<SeenFrame> seen = asc_event(words, format_.hexadecimal ? 16 : 10);
  if (seen) {
    seen->time_ns = time_ns_;
  }
  return seen;
}

}  // namespace host_sim::monitor
