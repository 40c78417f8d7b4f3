extern "C" int recursion(int depth) {
  volatile int here = depth;
  return depth == 0 ? here : recursion(depth - 1) + here;
}
