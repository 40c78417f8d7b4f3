// make_vectors FOLDER: writes random frames of three nodes as logs of candump, and what readers
// have to say about them as one JSON object a line:
//   clean.log, clean.jsonl     every frame in order
//   faulty.log, faulty.jsonl   with frames lost, repeated and damaged

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/e2e.hpp"
#include "hal/files/candump.hpp"
#include "tests/protocol/expected_values.hpp"
#include "tests/protocol/frames.hpp"
#include "tests/protocol/random_messages.hpp"

namespace {

using namespace protocol;
using test::Json;
using test::Random;

struct Sent {
  hal::CanFrame frame;
  Json expected;
};

/// Senders of all streams of the bus.
class Senders {
 public:
  template <class Message>
  Sent send(Node node, const Message& message) {
    hal::CanFrame frame = encode(node, message);
    if constexpr (schema::Layout<Message>::kFrame.integrity) {
      protectors_.try_emplace(frame.id, e2e::stream_of<Message>(node)).first->second.protect(frame);
    }
    const test::Expected expected = test::expected(message);
    return {frame,
            {{"node", node},
             {"name", expected.name},
             {"page", expected.page},
             {"signals", expected.signals},
             {"labels", expected.labels},
             {"error", nullptr}}};
  }

 private:
  std::map<std::uint32_t, e2e::Protector> protectors_;
};

std::vector<Sent> random_traffic(Random& random, std::size_t count) {
  Senders senders;
  std::vector<Sent> traffic;
  while (traffic.size() < count) {
    const Node node = test::one_of(random, std::array<Node, 3>{1, 7, 127});
    test::with_random_message(
        random, [&](const auto& message) { traffic.push_back(senders.send(node, message)); });
  }
  return traffic;
}

const char* name_of(e2e::Status status) {
  switch (status) {
    case e2e::Status::initial:
      return "initial";
    case e2e::Status::ok:
      return "ok";
    case e2e::Status::ok_some_lost:
      return "ok_some_lost";
    case e2e::Status::repeated:
      return "repeated";
    case e2e::Status::wrong_sequence:
      return "wrong_sequence";
    case e2e::Status::wrong_crc:
      return "wrong_crc";
    case e2e::Status::wrong_length:
      return "wrong_length";
    case e2e::Status::other_frame:
      return "other_frame";
  }
  return "";
}

/// Gives each frame the status that a Checker of its stream has for it.
class Receivers {
 public:
  std::string status_of(const hal::CanFrame& frame) {
    for (const schema::Frame* kind : schema::kFrames) {
      const auto node = node_of(*kind, frame);
      if (node && kind->integrity) {
        auto& checker = checkers_.try_emplace(frame.id, e2e::stream_of(*kind, *node)).first->second;
        return name_of(checker.check(frame));
      }
    }
    return "unprotected";
  }

 private:
  std::map<std::uint32_t, e2e::Checker> checkers_;
};

Sent damaged(Random& random, Sent sent) {
  const auto flips = 1 + random() % 3;
  const std::size_t first = random() % 21;
  for (std::size_t i = 0; i < flips; ++i) {
    sent.frame = test::flipped(sent.frame, first + 21 * i);
  }
  sent.expected["signals"] = sent.expected["labels"] = Json::object();
  sent.expected["page"] = nullptr;
  sent.expected["error"] = "wrong_crc";
  return sent;
}

std::vector<Sent> with_faults(Random& random, const std::vector<Sent>& traffic) {
  std::vector<Sent> arrived;
  for (const Sent& sent : traffic) {
    const auto fate = random() % 20;
    const bool is_protected = sent.expected["name"] != "Heartbeat";
    if (fate < 5) {
      continue;
    }
    arrived.push_back(fate == 5 && is_protected ? damaged(random, sent) : sent);
    if (fate == 6) {
      arrived.push_back(sent);
    }
    if (fate == 7 && arrived.size() > 40) {
      arrived.push_back(arrived[arrived.size() - 40]);
    }
  }
  return arrived;
}

void write(const std::filesystem::path& stem, std::vector<Sent> traffic) {
  std::ofstream log(stem.string() + ".log");
  std::ofstream lines(stem.string() + ".jsonl");
  Receivers receivers;
  std::uint64_t time_us = 1'700'000'000'000'000;
  for (Sent& sent : traffic) {
    log << hal::files::candump_line(time_us += 1000, "vcan0", sent.frame);
    sent.expected["status"] = receivers.status_of(sent.frame);
    lines << sent.expected.dump() << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  Random random(20240607);
  const std::vector<Sent> traffic = random_traffic(random, 5000);
  write(folder / "clean", traffic);
  write(folder / "faulty", with_faults(random, traffic));
}
