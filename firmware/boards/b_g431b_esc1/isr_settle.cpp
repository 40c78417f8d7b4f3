#include "firmware/boards/b_g431b_esc1/interrupts.hpp"
#include "firmware/boards/b_g431b_esc1/places.hpp"

namespace board {

extern "C" void isr_settle() {
  while (application().app().settle()) {
  }
}

}  // namespace board
