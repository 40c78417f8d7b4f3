extern "C" int somewhere_else(int);

extern "C" int unknown_callee(int value) {
  return somewhere_else(value) + 1;
}
