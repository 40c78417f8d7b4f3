#include "host_sim/command_line/roff.hpp"

#include <cctype>

#include "host_sim/command_line/quote.hpp"

namespace host_sim::command_line {
namespace {

/// A line that begins with one of these is a request.
std::string guarded(const std::string& text) {
  const bool request = !text.empty() && (text.front() == '.' || text.front() == '\'');
  return request ? "\\&" + text : text;
}

bool in_a_word(char before) {
  return std::isalnum(static_cast<unsigned char>(before)) != 0;
}

}  // namespace

std::string roff_text(const std::string& text) {
  std::string out;
  char before = ' ';
  for (const char letter : replace_all(text, "\\", "\\e")) {
    if (letter == '-' && !in_a_word(before)) {
      out += '\\';
    }
    out += letter;
    before = letter;
  }
  return guarded(out);
}

std::string roff_literal(const std::string& text) {
  return guarded(replace_all(replace_all(text, "\\", "\\e"), "-", "\\-"));
}

}  // namespace host_sim::command_line
