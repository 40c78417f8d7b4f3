#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "hal/slcan/port.hpp"
#include "tests/hal/slcan/wire.hpp"

namespace hal::slcan {
namespace {

using slcan_test::Wire;

FrameLine any_line() {
  FrameLine line;
  line.remote = *rc::gen::arbitrary<bool>();
  line.frame.extended = *rc::gen::arbitrary<bool>();
  const std::uint32_t highest = line.frame.extended ? kHighestExtendedId : kHighestStandardId;
  line.frame.id = *rc::gen::inRange<std::uint32_t>(0, highest + 1);
  line.frame.length = *rc::gen::inRange<std::uint8_t>(0, 9);
  if (!line.remote) {
    for (std::size_t i = 0; i < line.frame.length; ++i) {
      line.frame.data[i] = static_cast<std::byte>(*rc::gen::arbitrary<std::uint8_t>());
    }
  }
  return line;
}

std::string any_text() {
  const auto characters = rc::gen::elementOf(std::string("tTrRCOLSFVNZ0189aAgfF\r\r\r\r\n\a x"));
  std::string text;
  for (std::size_t pieces = *rc::gen::inRange<std::size_t>(0, 20); pieces > 0; --pieces) {
    text += *rc::gen::weightedOneOf<std::string>(
        {{1, rc::gen::container<std::string>(characters)},
         {1,
          rc::gen::map(rc::gen::inRange(20, 40),
                       [](int n) { return std::string(static_cast<std::size_t>(n), '1') + "\r"; })},
         {3, rc::gen::exec([] { return std::string(format(any_line()).view()); })},
         {1, rc::gen::element<std::string>("C\r", "S8\r", "O\r", "L\r", "F\r", "V\r")}});
  }
  return text;
}

struct Outcome {
  std::vector<CanFrame> frames;
  std::string answers;

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// Reads until the line is empty.
void drain(Port<Wire>& port, Wire& wire, Outcome& outcome) {
  for (bool more = true; more;) {
    const auto frame = port.receive();
    if (frame) {
      outcome.frames.push_back(*frame);
    }
    more = frame.has_value() || wire.unread() > 0;
  }
}

RC_GTEST_PROP(SlcanProperty, WhatIsFormattedIsReadBack, ()) {
  const FrameLine line = any_line();
  const std::string text(format(line).view());
  RC_ASSERT(text.back() == '\r');
  RC_ASSERT(text.size() <= kLongestLine + 1);
  const auto read = parse_frame(std::string_view(text).substr(0, text.size() - 1));
  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == line);
}

RC_GTEST_PROP(SlcanProperty, WhatIsReadIsFormattedBack, ()) {
  std::string text(format(any_line()).view());
  text.pop_back();
  const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
  text[at] = *rc::gen::elementOf(std::string("0123456789ABCDEFtTrRg"));
  if (const auto read = parse_frame(text)) {
    RC_ASSERT(format(*read).view() == text + "\r");
  }
}

RC_GTEST_PROP(SlcanProperty, ChunksMakeNoDifference, ()) {
  const std::string text = any_text();
  Outcome whole;
  {
    Wire wire;
    Port<Wire> port(wire, Channel::open);
    wire.host_writes(text);
    drain(port, wire, whole);
    whole.answers = wire.host_reads();
  }
  Outcome pieces;
  Wire wire;
  Port<Wire> port(wire, Channel::open);
  for (std::size_t at = 0; at < text.size();) {
    const auto size = *rc::gen::inRange<std::size_t>(1, 30);
    wire.host_writes(std::string_view(text).substr(at, size));
    at += size;
    drain(port, wire, pieces);
  }
  pieces.answers = wire.host_reads();
  RC_ASSERT(pieces == whole);
}

RC_GTEST_PROP(SlcanProperty, EveryLineGetsOneAnswerOfItsOwn, ()) {
  std::string text = any_text();
  text += '\r';
  Wire wire;
  Port<Wire> port(wire, Channel::open);
  wire.host_writes(text);
  Outcome outcome;
  drain(port, wire, outcome);
  std::erase(text, '\n');
  const auto lines = std::ranges::count(text, '\r');
  std::ptrdiff_t empty = text.front() == '\r' ? 1 : 0;
  for (std::size_t i = 1; i < text.size(); ++i) {
    empty += text[i] == '\r' && text[i - 1] == '\r' ? 1 : 0;
  }
  const std::string answers = wire.host_reads();
  const auto ends = std::ranges::count_if(answers, [](char c) { return c == '\r' || c == '\a'; });
  RC_ASSERT(ends == lines - empty);
}

RC_GTEST_PROP(SlcanProperty, SentFramesAreNeverTornByALineThatStalls, ()) {
  Wire wire;
  Port<Wire> port(wire, Channel::open);
  std::string expected;
  std::string got;
  for (std::size_t i = *rc::gen::inRange<std::size_t>(0, 80); i > 0; --i) {
    wire.set_room(*rc::gen::inRange<std::size_t>(0, 40));
    FrameLine line = any_line();
    line.remote = false;
    if (port.send(line.frame) == Error::none) {
      expected += format(line).view();
    }
    got += wire.host_reads();
  }
  wire.set_room(100'000);
  RC_ASSERT(!port.receive().has_value());
  got += wire.host_reads();
  RC_ASSERT(got == expected);
}

}  // namespace
}  // namespace hal::slcan
