extern "C" [[gnu::used]] void in_flash() {
  __asm__ volatile("nop");
}
