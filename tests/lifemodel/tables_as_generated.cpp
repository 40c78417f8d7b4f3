#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: tables_as_generated GENERATOR TABLES\n";
    return 2;
  }
  std::FILE* generator = popen(argv[1], "r");
  std::string printed;
  for (int c = std::fgetc(generator); c != EOF; c = std::fgetc(generator)) {
    printed.push_back(static_cast<char>(c));
  }
  const bool ran = pclose(generator) == 0;
  std::ifstream file(argv[2], std::ios::binary);
  const std::string committed{std::istreambuf_iterator<char>(file), {}};
  if (!ran || committed.empty() || printed != committed) {
    std::cerr << argv[2] << " is not what " << argv[1] << " prints\n";
    return 1;
  }
}
