// Plays a recording in virtual time and counts the instructions of each call of the application.
// Arguments are the words of image/options.hpp; `summary` is the JSON file to write.

#include <algorithm>
#include <cstdint>
#include <span>

#include "firmware/boards/qemu_mps2/image/machine.hpp"
#include "firmware/boards/qemu_mps2/image/options.hpp"
#include "firmware/boards/qemu_mps2/image/recording.hpp"
#include "firmware/boards/qemu_mps2/image/run_files.hpp"
#include "firmware/boards/qemu_mps2/image/virtual_run.hpp"
#include "firmware/boards/qemu_mps2/measurement.hpp"
#include "firmware/boards/qemu_mps2/semihosting.hpp"
#include "firmware/boards/qemu_mps2/text.hpp"
#include "tests/target/firmware/entry/entry.hpp"

namespace board = boards::qemu_mps2;

namespace firmware_test {
namespace {

struct Count {
  std::uint32_t calls = 0;
  std::uint32_t sum = 0;
  std::uint32_t worst = 0;

  void add(std::uint32_t instructions) {
    ++calls;
    sum += instructions;
    worst = std::max(worst, instructions);
  }
};

/// The application with a counter around it, for the player.
class CountedApp {
 public:
  explicit CountedApp(App& app) : app_(app) {}

  void start() { app_.start(); }
  bool isr_sample() {
    bool due = false;
    isr_sample_.add(counter_.count({app_isr_sample, &app_, &due}));
    return due;
  }
  void isr_missed(std::uint32_t periods) { app_.isr_missed(periods); }
  bool settle() {
    bool more = false;
    settle_.add(counter_.count({app_settle, &app_, &more}));
    return more;
  }
  void poll() { poll_.add(counter_.count({app_poll, &app_})); }
  hal::Error stop() { return app_.stop(); }

  bool write(const char* path) const {
    board::Text<400> json;
    json << "{\"isr_sample\": ";
    put(json, isr_sample_);
    put(json << ", \"settle\": ", settle_);
    put(json << ", \"poll\": ", poll_);
    json << "}\n";
    board::HostFile file(path, board::HostFile::Mode::write);
    return file.is_open() && file.write(std::as_bytes(std::span(json.c_str(), json.size())));
  }

 private:
  static void put(board::Text<400>& json, const Count& count) {
    json << "[" << count.calls << ", " << count.sum << ", " << count.worst << "]";
  }

  App& app_;
  board::InstructionCounter counter_;
  Count isr_sample_;
  Count settle_;
  Count poll_;
};

/// The machine as the player sees it.
struct CountedMachine {
  Machine& machine;
  CountedApp app{machine.app};
  boards::qemu_mps2::PlayedCurrent& sensor = machine.sensor;
  hal::qemu_mps2::InputLine& emergency_stop = machine.emergency_stop;
};

int run(const board::Options& options) {
  board::HostFile profile_file(options.profile, board::HostFile::Mode::read);
  board::HostFile events(options.events, board::HostFile::Mode::read);
  auto& profile = board::make_once<board::Profile<board::HostFile>>(profile_file);
  board::Settings settings;
  settings.channel = hal::slcan::Channel::open;
  settings.config = options.config;
  settings.seed = options.seed;
  if (!events.is_open() || profile.open() != nullptr ||
      board::read_block<board::HostFile>(options, settings.models)) {
    return 1;
  }
  NullLine line;
  Host host(line);
  hal::qemu_mps2::VirtualClock clock;
  hal::qemu_mps2::NoBacking backing;
  hal::NoHold hold;
  auto& machine = board::make_once<Machine>(host, clock, backing, hold, settings);
  CountedMachine counted{machine};
  board::Script script(&events);
  board::Player player(counted, clock, host, profile, script);
  return player.play() == nullptr && counted.app.write(options.summary) ? 0 : 1;
}

}  // namespace
}  // namespace firmware_test

int main() {
  const board::Arguments arguments;
  board::OptionReader reader;
  for (const char* word : arguments.words().subspan(1)) {
    if (reader.take(word) != nullptr) {
      return 2;
    }
  }
  return firmware_test::run(reader.options());
}
