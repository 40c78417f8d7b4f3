// Reads where there is no memory.

#include <cstdint>

int main() {
  return *reinterpret_cast<const volatile int*>(std::uintptr_t{0xA0000000});
}
