// Makes a recording: the samples of a scenario, and what a live host does to the node while it
// runs.
//
// usage: record SCENARIO SERIAL profile=FILE block=FILE events=FILE [NAME=VALUE]...
//        record --list
//        record --block FILE                the parameter block alone
//        record --command NODE CODE ARGUMENT   the line of the first command of a host

#include <array>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <iostream>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "firmware/boards/qemu_mps2/image/options.hpp"
#include "firmware/boards/qemu_mps2/image/virtual_run.hpp"
#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/pack/pack.hpp"
#include "tests/target/firmware/host_files.hpp"
#include "tests/target/firmware/scenarios.hpp"
#include "tests/target/model/paper_model.hpp"

namespace board = boards::qemu_mps2;

namespace firmware_test {
namespace {

template <class Container>
void put(std::ofstream& out, const Container& data) {
  out.write(reinterpret_cast<const char*>(std::data(data)),
            static_cast<std::streamsize>(std::size(data)));
}

void put_word(std::ofstream& out, std::uint32_t word) {
  std::array<std::byte, 4> bytes_of{};
  lifemodel::ByteWriter(bytes_of).u32(word);
  put(out, bytes_of);
}

bool write_profile(const Scenario& scenario, const char* path) {
  using Header = board::ProfileHeader;
  std::ofstream out(path, std::ios::binary);
  for (const std::uint32_t word : {Header::kMagic, Header::kVersion, std::uint32_t{board::kTendons},
                                   scenario.sample_period_us}) {
    put_word(out, word);
  }
  const std::uint32_t samples = scenario.duration_ms * 1'000 / scenario.sample_period_us;
  for (std::uint32_t i = 0; i < samples; ++i) {
    for (std::size_t tendon = 0; tendon < board::kTendons; ++tendon) {
      const double time_s = i * 1e-6 * scenario.sample_period_us;
      put_word(out, static_cast<std::uint32_t>(scenario.current(time_s, tendon)));
    }
  }
  return out.flush().good();
}

/// Lets the scenario and its tester act while the node runs, and writes down what they do.
class LiveScript {
 public:
  LiveScript(const Scenario& scenario, const app::Config& config, SerialFile& serial,
             const char* events)
      : scenario_(scenario),
        tester_(config.node, config.key),
        serial_(serial),
        events_(events, std::ios::binary) {}

  std::optional<Event> due(hal::Time now) {
    if (now.us % 1'000 == 0 && now != last_) {
      last_ = now;
      act(now);
    }
    if (happening_.empty()) {
      return std::nullopt;
    }
    Event event = happening_.front();
    happening_.pop_front();
    event.at_ms = static_cast<std::uint32_t>(now.us / 1'000);
    put_word(events_, event.at_ms);
    put_word(events_, static_cast<std::uint32_t>(event.kind));
    put(events_, event.payload);
    return event;
  }

  [[nodiscard]] bool close() {
    events_.close();
    return events_.good() && next_ == scenario_.deeds.size();
  }

 private:
  void act(hal::Time now) {
    for (; next_ < scenario_.deeds.size() && hal::milliseconds(scenario_.deeds[next_].at_ms) <= now;
         ++next_) {
      for (const Event& event : scenario_.deeds[next_].act(tester_)) {
        happening_.push_back(event);
      }
    }
    for (const std::string& line : tester_.turn(now, serial_.news())) {
      happening_.push_back(line_of(line));
    }
  }

  const Scenario& scenario_;
  Tester tester_;
  SerialFile& serial_;
  std::ofstream events_;
  std::deque<Event> happening_;
  std::size_t next_ = 0;
  hal::Time last_{};
};

/// Of the paper's model, whose wires shall last an hour of operation at a risk of a tenth.
bool write_block(const char* path) {
  lifemodel::Parameters parameters = target::paper_parameters<1>()[0];
  parameters.watch.advice_risk = lifemodel::pack::from_double<lifemodel::Ratio>(0.1);
  parameters.watch.advice_until_s = 3'600;
  std::ofstream block(path, std::ios::binary);
  put(block, lifemodel::encode(parameters));
  block.close();
  return block.good();
}

int record(const Scenario& scenario, const char* serial_path, const board::Options& options) {
  if (!write_block(options.block) || !write_profile(scenario, options.profile)) {
    std::cerr << "record: cannot write profile or block\n";
    return 1;
  }
  SerialFile serial(serial_path);
  LiveScript script(scenario, options.config, serial, options.events);
  const board::Failure failure = board::play_profile<HostFile>(options, serial, script);
  if (failure || !script.close() || !serial.close()) {
    std::cerr << "record: " << (failure ? failure.what : "not all could be written") << "\n";
    return 1;
  }
  return 0;
}

void print_command(const char* node, const char* code, const char* argument) {
  Tester tester(static_cast<protocol::Node>(std::atoi(node)), {});
  std::cout << tester.command({static_cast<protocol::CommandCode>(std::atoi(code)),
                               static_cast<std::uint8_t>(std::atoi(argument))});
}

int record(std::string_view name, std::span<char*> words) {
  board::OptionReader reader;
  for (const char* word : words.subspan(1)) {
    if (const char* accepted = reader.take(word)) {
      std::cerr << "record: " << word << ": accepted: " << accepted << "\n";
      return 2;
    }
  }
  for (const Scenario& scenario : scenarios()) {
    if (name == scenario.name) {
      return record(scenario, words[0], reader.options());
    }
  }
  std::cerr << "record: " << name << ": accepted: what --list prints\n";
  return 2;
}

int run(std::span<char*> words) {
  const std::string_view first = words.size() > 1 ? words[1] : "";
  if (first == "--list" && words.size() == 2) {
    for (const Scenario& scenario : scenarios()) {
      std::cout << scenario.name << "\n";
    }
    return 0;
  }
  if (first == "--block" && words.size() == 3) {
    return write_block(words[2]) ? 0 : 1;
  }
  if (first == "--command" && words.size() == 5) {
    print_command(words[2], words[3], words[4]);
    return 0;
  }
  return words.size() > 2 ? record(first, words.subspan(2)) : 2;
}

}  // namespace
}  // namespace firmware_test

int main(int argc, char** argv) {
  return firmware_test::run(std::span(argv, static_cast<std::size_t>(argc)));
}
