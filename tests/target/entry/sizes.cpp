// Sizes as the sizes of symbols, for a tool to read.

#include "tests/target/entry/entry.hpp"

extern "C" {

extern const char state_one[sizeof(target::One)];
const char state_one[sizeof(target::One)] = {};

/// Each tendon more.
extern const char state_more[(sizeof(target::Four) - sizeof(target::One)) / 3];
const char state_more[(sizeof(target::Four) - sizeof(target::One)) / 3] = {};

}  // extern "C"
