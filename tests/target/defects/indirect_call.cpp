extern "C" int indirect_call(int (*function)(int)) {
  return function(1) + 1;
}
