int scaled(int value) {
  return static_cast<int>(static_cast<float>(value) * 1.5f);
}
