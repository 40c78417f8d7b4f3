#include "tests/blind/generator/scenario.hpp"

namespace blind {

std::string_view word_of(Kind kind) {
  switch (kind) {
    case Kind::none:
      return "none";
    case Kind::one:
      return "one";
    case Kind::two:
      return "two";
    case Kind::outside:
      return "outside";
  }
  return "";
}

std::string_view word_of(Design design) {
  return design == Design::crossed ? "crossed" : "one_pose";
}

std::string_view word_of(Input input) {
  return input == Input::load_cell ? "load_cell" : "motor_current";
}

std::string_view word_of(Data data) {
  return data == Data::recordings ? "recordings" : "lives";
}

}  // namespace blind
