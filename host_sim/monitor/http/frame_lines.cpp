#include "host_sim/monitor/http/frame_lines.hpp"

#include <charconv>
#include <string>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/isotp/address.hpp"
#include "firmware/protocol/schema/plan.hpp"

namespace host_sim::monitor {
namespace {

std::optional<protocol::Node> node_of_plan(const hal::CanFrame& frame) {
  for (const protocol::schema::Frame* kind : protocol::schema::kFrames) {
    if (const auto node = protocol::node_of(*kind, frame)) {
      return node;
    }
  }
  return std::nullopt;
}

std::optional<protocol::Node> node_of_diagnosis(const hal::CanFrame& frame) {
  const auto address = protocol::isotp::Address::of(frame);
  if (!address) {
    return std::nullopt;
  }
  return address->source == protocol::isotp::kTester ? address->target : address->source;
}

}  // namespace

std::optional<protocol::Node> node_of_line(std::string_view line) {
  const std::size_t end = line.find('#');
  const std::size_t begin = line.rfind(' ', end);
  if (end == std::string_view::npos || begin == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view digits = line.substr(begin + 1, end - begin - 1);
  hal::CanFrame frame;
  const char* const last = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), last, frame.id, 16);
  if (error != std::errc{} || stop != last) {
    return std::nullopt;
  }
  constexpr std::size_t kStandardDigits = 3;
  frame.extended = digits.size() != kStandardDigits;
  return frame.extended ? node_of_diagnosis(frame) : node_of_plan(frame);
}

bool take_lines(std::string_view lines, std::optional<protocol::Node> node,
                const std::function<bool(std::string_view)>& take) {
  if (!node) {
    return take(lines);
  }
  std::string of_node;
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n') + 1);
    if (node_of_line(line) == node) {
      of_node += line;
    }
    lines.remove_prefix(line.size());
  }
  return of_node.empty() || take(of_node);
}

}  // namespace host_sim::monitor
