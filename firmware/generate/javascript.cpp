#include <charconv>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "firmware/generate/assets.hpp"
#include "firmware/generate/generate.hpp"
#include "firmware/protocol/schema/plan.hpp"

namespace protocol::generate {
namespace {

using Json = nlohmann::ordered_json;
using schema::Frame;
using schema::MessageView;
using schema::Signal;

Json json_of(const Signal& signal) {
  double factor = 0.0;
  std::from_chars(signal.factor.data(), signal.factor.data() + signal.factor.size(), factor);
  Json json{{"name", signal.name},       {"startBit", signal.start_bit},
            {"bits", signal.bits},       {"factor", factor},
            {"unit", signal.unit},       {"comment", signal.comment},
            {"closed", signal.is_closed}};
  for (const schema::ValueName& value : signal.values) {
    json["values"][std::to_string(value.value)] = value.name;
  }
  return json;
}

Json json_of(const MessageView& message) {
  Json json{{"name", message.name}, {"comment", message.comment}, {"signals", Json::array()}};
  if (message.page) {
    json["page"] = *message.page;
  }
  for (const Signal& signal : message.signals) {
    json["signals"].push_back(json_of(signal));
  }
  return json;
}

Json json_of(const Frame& frame) {
  Json json{{"name", frame.name},
            {"baseId", frame.base_id},
            {"length", frame.length},
            {"cycleMs", frame.cycle_ms},
            {"comment", frame.comment}};
  if (frame.integrity) {
    json["integrity"] = {{"crcByte", frame.integrity->crc_byte},
                         {"idList", frame.integrity->id_list}};
  }
  if (frame.page) {
    json["pageSignal"] = json_of(*frame.page);
  }
  json["messages"] = Json::array();
  for (const MessageView& message : schema::kMessages) {
    if (message.frame == &frame) {
      json["messages"].push_back(json_of(message));
    }
  }
  return json;
}

}  // namespace

std::string javascript() {
  Json plan = Json::array();
  for (const Frame* frame : schema::kFrames) {
    plan.push_back(json_of(*frame));
  }
  std::string text =
      "// The frame plan of tendonlife. Written by protocol_generate: do not edit.\n";
  text += "export const plan = " + plan.dump(1) + ";\n\n";
  text += assets::decoder_mjs;
  return text;
}

}  // namespace protocol::generate
