long long divided(long long a, long long b) {
  return a / b;
}
