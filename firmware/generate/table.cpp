#include "firmware/protocol/uds/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "firmware/generate/decimal.hpp"
#include "firmware/generate/generate.hpp"
#include "firmware/protocol/isotp/pdu.hpp"
#include "firmware/protocol/schema/plan.hpp"

namespace protocol::generate {
namespace {

using schema::Frame;
using schema::MessageView;
using schema::Signal;

/// Where a signal lies: b3 is byte 3, b2-5 are bytes, b1.4-7 are bits 4 to 7 of byte 1.
std::string position_of(const Signal& signal) {
  const int byte = signal.start_bit / 8;
  const int bit = signal.start_bit % 8;
  if (signal.bits == 8 && bit == 0) {
    return fmt::format("b{}", byte);
  }
  if (signal.bits % 8 == 0 && bit == 0) {
    return fmt::format("b{}-{}", byte, byte + signal.bits / 8 - 1);
  }
  if (signal.bits == 1) {
    return fmt::format("b{}.{}", byte, bit);
  }
  return fmt::format("b{}.{}-{}", byte, bit, bit + signal.bits - 1);
}

std::string described(const Signal& signal) {
  std::string text = fmt::format("{} {}", position_of(signal), signal.name);
  if (signal.factor != "1") {
    text += " x " + readable(signal.factor);
  }
  if (!signal.unit.empty()) {
    text += fmt::format(" {}", signal.unit);
  }
  return text;
}

void add(std::string& list, const std::string& item) {
  list += (list.empty() ? "" : ", ") + item;
}

/// What lies in the bytes, in their order.
std::string content_of(std::vector<Signal> signals) {
  std::sort(signals.begin(), signals.end(),
            [](const Signal& a, const Signal& b) { return a.start_bit < b.start_bit; });
  std::string list;
  for (const Signal& signal : signals) {
    add(list, described(signal));
  }
  return list;
}

std::vector<Signal> header_of(const Frame& frame) {
  std::vector<Signal> signals;
  if (frame.integrity) {
    signals = {crc_signal(*frame.integrity), counter_signal(*frame.integrity)};
  }
  if (frame.page) {
    signals.push_back(*frame.page);
  }
  return signals;
}

std::string content_of(const MessageView& message) {
  std::vector<Signal> signals = message.page ? std::vector<Signal>{} : header_of(*message.frame);
  signals.insert(signals.end(), message.signals.begin(), message.signals.end());
  return content_of(std::move(signals));
}

void add_frame(std::string& text, const Frame& frame) {
  const std::string head =
      fmt::format("| 0x{:03X} + n | {} | {} |", frame.base_id, frame.name, frame.sent);
  if (frame.page) {
    text += fmt::format("{} {} |\n", head, content_of(header_of(frame)));
  }
  for (const MessageView& message : schema::kMessages) {
    if (message.frame == &frame) {
      text += message.page ? fmt::format("| | page {} {} | {} |", *message.page, message.name,
                                         message.comment)
                           : head;
      text += fmt::format(" {} |\n", content_of(message));
    }
  }
}

/// Identifiers of ISO-TP, with nn for the node.
std::string diagnostic_id(const isotp::Address& address) {
  const auto part = [](std::uint8_t byte) {
    return byte == isotp::kTester ? fmt::format("{:02X}", byte) : std::string("nn");
  };
  return fmt::format("0x{:04X} {} {}", address.id() >> 16, part(address.target),
                     part(address.source));
}

std::string values_of(const Signal& signal) {
  std::string list;
  for (const schema::ValueName& value : signal.values) {
    const bool large = value.value > 0xff;
    add(list,
        fmt::format("{} {}",
                    large ? fmt::format("0x{:04x}", value.value) : fmt::format("{}", value.value),
                    value.name));
  }
  return list;
}

/// Signals that have the same values share a line.
std::string all_values() {
  std::vector<std::pair<std::string, std::string>> lines;  // values, and whose they are
  for (const MessageView& message : schema::kMessages) {
    for (const Signal& signal : message.signals) {
      if (signal.values.empty()) {
        continue;
      }
      const std::string values = values_of(signal);
      auto line = std::find_if(lines.begin(), lines.end(),
                               [&](const auto& known) { return known.first == values; });
      if (line == lines.end()) {
        line = lines.insert(lines.end(), {values, {}});
      }
      add(line->second, std::string(signal.name));
    }
  }
  std::string text;
  for (const auto& [values, signals] : lines) {
    text += fmt::format("| {} | {} |\n", signals, values);
  }
  return text;
}

}  // namespace

std::string table() {
  std::string text = "| id | frame | sent | content |\n|---|---|---|---|\n";
  for (const Frame* frame : schema::kFrames) {
    add_frame(text, *frame);
  }
  text += fmt::format("| {} | Request | on request | UDS over ISO-TP, 29 bits |\n",
                      diagnostic_id(isotp::Address::to_node(0)));
  text += fmt::format("| {} | Response | on request | UDS over ISO-TP, 29 bits |\n",
                      diagnostic_id(isotp::Address::to_tester(0)));
  text += "\n| signal | values |\n|---|---|\n" + all_values();
  return text;
}

std::string services() {
  std::string text;
  uds::describe([&text](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace protocol::generate
