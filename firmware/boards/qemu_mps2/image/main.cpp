// The firmware on the board of QEMU. options.hpp has what it takes on the command line.

#include "firmware/boards/qemu_mps2/image/options.hpp"
#include "firmware/boards/qemu_mps2/image/real_time_run.hpp"
#include "firmware/boards/qemu_mps2/image/virtual_run.hpp"
#include "firmware/boards/qemu_mps2/registers.hpp"
#include "firmware/boards/qemu_mps2/semihosting.hpp"

namespace board = boards::qemu_mps2;

namespace {

void complain(const char* about, const char* what) {
  board::write("qemu_firmware: ");
  if (about != nullptr) {
    board::write(about);
    board::write(": ");
  }
  board::write(what);
  board::write("\n");
}

board::Failure run(const board::Options& options) {
  if (options.real_time) {
    return board::run_in_real_time(options);
  }
  board::Uart0 uart(board::uart0_registers());
  if (uart.start(board::kClock_Hz, board::kUart0_bits_per_s) != hal::Error::none) {
    return {nullptr, "UART 0 does not start"};
  }
  return board::run_in_virtual_time<board::HostFile>(options, uart);
}

}  // namespace

int main() {
  constexpr int kBadInput = 1;
  constexpr int kUsage = 2;
  const board::Arguments arguments;
  board::OptionReader reader;
  for (const char* word : arguments.words().subspan(arguments.count() == 0 ? 0 : 1)) {
    if (const char* accepted = reader.take(word)) {
      complain(word, "not accepted here; accepted:");
      complain(word, accepted);
      return kUsage;
    }
  }
  if (reader.options().profile == nullptr) {
    complain("profile", "missing; accepted: profile=FILE");
    return kUsage;
  }
  if (const board::Failure failure = run(reader.options())) {
    complain(failure.about, failure.what);
    return kBadInput;
  }
  return 0;
}
