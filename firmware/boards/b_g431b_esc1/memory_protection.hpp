#pragma once

namespace board {

/// Makes the lowest bytes of the stack, which lies lowest in its memory, fault.
void guard_stack();

}  // namespace board
