extern "C" void consume(char*);

extern "C" void variable_frame(unsigned size) {
  consume(static_cast<char*>(__builtin_alloca(size)));
}
