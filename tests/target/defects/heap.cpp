int* one_more() {
  return new int(1);
}
