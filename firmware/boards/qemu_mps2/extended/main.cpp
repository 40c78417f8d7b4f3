// The firmware with an extended model on the board of QEMU, in virtual time. It takes the words of
// image/options.hpp but real_time and seconds.

#include "firmware/boards/qemu_mps2/extended/swinging_drive.hpp"
#include "firmware/boards/qemu_mps2/image/virtual_run.hpp"
#include "firmware/boards/qemu_mps2/registers.hpp"
#include "firmware/boards/qemu_mps2/semihosting.hpp"

namespace board = boards::qemu_mps2;

namespace {

void complain(const char* about, const char* what) {
  board::write("qemu_firmware_extended: ");
  board::write(about == nullptr ? "run" : about);
  board::write(": ");
  board::write(what);
  board::write("\n");
}

}  // namespace

int main() {
  constexpr int kBadInput = 1;
  constexpr int kUsage = 2;
  const board::Arguments arguments;
  board::OptionReader reader;
  for (const char* word : arguments.words().subspan(arguments.count() == 0 ? 0 : 1)) {
    if (const char* accepted = reader.take(word)) {
      complain(word, accepted);
      return kUsage;
    }
  }
  if (reader.options().profile == nullptr) {
    complain("profile", "missing; accepted: profile=FILE");
    return kUsage;
  }
  board::Uart0 uart(board::uart0_registers());
  if (uart.start(board::kClock_Hz, board::kUart0_bits_per_s) != hal::Error::none) {
    complain("UART 0", "does not start");
    return kBadInput;
  }
  if (const board::Failure failure =
          board::run_in_virtual_time<board::HostFile, board::SwingingDrive>(reader.options(),
                                                                            uart)) {
    complain(failure.about, failure.what);
    return kBadInput;
  }
  return 0;
}
