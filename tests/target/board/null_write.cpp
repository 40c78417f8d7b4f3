// Writes through a null pointer.

#include <cstdint>

namespace {

volatile std::uintptr_t null = 0;

}  // namespace

int main() {
  *reinterpret_cast<volatile int*>(null) = 1;
  return 0;
}
