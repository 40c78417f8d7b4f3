// Runs off the end of the stack.

namespace {

[[gnu::noinline]] int descend(volatile int* previous) {
  volatile int here = *previous + 1;
  if (here < 0) {
    return 0;
  }
  return descend(&here) + here;
}

}  // namespace

int main() {
  volatile int start = 0;
  return descend(&start) == 0 ? 0 : 1;
}
