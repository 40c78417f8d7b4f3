// Runs from RAM and calls what does not.
extern "C" {
void in_flash();
void isr_reset() {}
void isr_control() {
  in_flash();
}
}
