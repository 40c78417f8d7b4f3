#include "tests/target/firmware/entry/entry.hpp"

namespace firmware_test {

extern "C" void app_isr_sample(App* app, bool* due) {
  *due = app->isr_sample();
}
extern "C" void app_settle(App* app, bool* more) {
  *more = app->settle();
}
extern "C" void app_poll(App* app) {
  app->poll();
}

/// Never run: its size is that of the application.
extern "C" char app_state[sizeof(App)];
char app_state[sizeof(App)];
/// The same of the store, without the flash below it.
extern "C" char store_state[sizeof(Machine::Store)];
char store_state[sizeof(Machine::Store)];

}  // namespace firmware_test
