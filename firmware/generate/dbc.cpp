#include <fmt/format.h>

#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/generate/decimal.hpp"
#include "firmware/generate/generate.hpp"
#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/schema/plan.hpp"

namespace protocol::generate {
namespace {

using schema::Frame;
using schema::MessageView;
using schema::Signal;

constexpr std::string_view kHead =
    "VERSION \"\"\n\nNS_ :\n\tCM_\n\tBA_DEF_\n\tBA_\n\tVAL_\n\tBA_DEF_DEF_\n\nBS_:\n\n";
constexpr std::string_view kAttributes =
    "BA_DEF_  \"BusType\" STRING ;\n"
    "BA_DEF_ BO_  \"GenMsgCycleTime\" INT 0 65535;\n"
    "BA_DEF_DEF_  \"BusType\" \"CAN\";\n"
    "BA_DEF_DEF_  \"GenMsgCycleTime\" 0;\n"
    "BA_ \"BusType\" \"CAN\";\n";

/// A signal as one frame has it: of the frame itself, or of one of its pages.
struct FrameSignal {
  Signal signal;
  std::string multiplexing;  ///< "", "M" or "m" and the page
  std::string_view page;     ///< name of the page, or nothing
};

std::vector<FrameSignal> signals_of(const Frame& frame) {
  std::vector<FrameSignal> signals;
  if (frame.integrity) {
    signals.push_back({crc_signal(*frame.integrity), "", {}});
    signals.push_back({counter_signal(*frame.integrity), "", {}});
  }
  if (frame.page) {
    signals.push_back({*frame.page, "M", {}});
  }
  for (const MessageView& message : schema::kMessages) {
    if (message.frame == &frame) {
      const std::string page = message.page ? fmt::format("m{}", *message.page) : "";
      for (const Signal& signal : message.signals) {
        signals.push_back({signal, page, message.page ? message.name : std::string_view{}});
      }
    }
  }
  return signals;
}

std::vector<schema::ValueName> pages_of(const Frame& frame) {
  std::vector<schema::ValueName> pages;
  for (const MessageView& message : schema::kMessages) {
    if (message.frame == &frame && message.page) {
      pages.push_back({*message.page, message.name});
    }
  }
  return pages;
}

/// The sections of a file, each of lines of one sort, in the order that readers expect.
class Writer {
 public:
  /// `node`: nothing for a template.
  void add(std::optional<Node> node) {
    const std::string sender = node ? fmt::format("Node{}", *node) : "Node";
    nodes_ += ' ' + sender;
    for (const Frame* frame : schema::kFrames) {
      add(*frame, id_of(*frame, node.value_or(0)),
          node ? fmt::format("{}_{}", frame->name, *node) : std::string(frame->name), sender);
    }
  }
  std::string text(std::string_view comment) const {
    return fmt::format("{}BU_:{} Host\n\n{}CM_ \"{}\";\n{}{}{}{}", kHead, nodes_, messages_,
                       comment, comments_, kAttributes, attributes_, values_);
  }

 private:
  template <class... Args>
  static void append(std::string& to, fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(to), format, std::forward<Args>(args)...);
  }

  void add(const Frame& frame, std::uint32_t id, std::string_view name, std::string_view node) {
    const bool from_node = frame.sender == schema::Sender::node;
    append(messages_, "BO_ {} {}: {} {}\n", id, name, frame.length, from_node ? node : "Host");
    append(comments_, "CM_ BO_ {} \"{}, {}\";\n", id, frame.comment, frame.sent);
    if (frame.cycle_ms != 0) {
      append(attributes_, "BA_ \"GenMsgCycleTime\" BO_ {} {};\n", id, frame.cycle_ms);
    }
    for (const FrameSignal& placed : signals_of(frame)) {
      add(placed, id, from_node ? "Host" : node);
    }
    if (frame.page) {
      add_values(id, frame.page->name, pages_of(frame));
    }
    messages_ += '\n';
  }

  void add(const FrameSignal& placed, std::uint32_t id, std::string_view receiver) {
    const Signal& signal = placed.signal;
    const std::string largest = times(schema::largest(signal.bits), signal.factor);
    append(messages_, " SG_ {}{}{} : {}|{}@1+ ({},0) [0|{}] \"{}\" {}\n", signal.name,
           placed.multiplexing.empty() ? "" : " ", placed.multiplexing, signal.start_bit,
           signal.bits, signal.factor, largest, signal.unit, receiver);
    append(comments_, "CM_ SG_ {} {} \"{}{}{}\";\n", id, signal.name, placed.page,
           placed.page.empty() ? "" : ": ", signal.comment);
    if (!signal.values.empty()) {
      add_values(id, signal.name, {signal.values.begin(), signal.values.end()});
    }
  }

  void add_values(std::uint32_t id, std::string_view name,
                  const std::vector<schema::ValueName>& values) {
    append(values_, "VAL_ {} {}", id, name);
    for (const schema::ValueName& value : values) {
      append(values_, " {} \"{}\"", value.value, value.name);
    }
    values_ += " ;\n";
  }

  std::string nodes_;
  std::string messages_;
  std::string comments_;
  std::string attributes_;
  std::string values_;
};

}  // namespace

std::string dbc(std::span<const Node> nodes) {
  Writer writer;
  for (const Node node : nodes) {
    writer.add(node);
  }
  return writer.text("Tendon life, exact identifiers of each node");
}

std::string dbc_template() {
  Writer writer;
  writer.add(std::nullopt);
  return writer.text(
      "Tendon life of one node, mask identifiers with 0x780, their low 7 bits are the node");
}

}  // namespace protocol::generate
