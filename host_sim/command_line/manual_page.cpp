#include "host_sim/command_line/manual_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

#include "host_sim/command_line/quote.hpp"

namespace host_sim::command_line {
namespace {

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return text;
}

std::string bold(const std::string& text) {
  return fmt::format("\\fB{}\\fR", roff_literal(text));
}

std::string italic(const std::string& text) {
  return fmt::format("\\fI{}\\fR", roff_literal(text));
}

/// A description as one sentence that ends.
std::string sentence(const std::string& text) {
  return text.empty() || text.back() == '.' ? roff_text(text) : roff_text(text) + ".";
}

std::string heading_of(const Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names) {
    names.push_back(bold(name));
  }
  std::string text = fmt::format("{}", fmt::join(names, ", "));
  if (option.has_value) {
    text += fmt::format(" {}", italic(option.value.name));
  }
  return text;
}

/// What a value may be, and what it is without the option; after a description.
std::string remarks_on(const Value& value) {
  std::string text;
  if (!value.choices.empty()) {
    std::vector<std::string> choices;
    for (const std::string& choice : value.choices) {
      choices.push_back(bold(choice));
    }
    text += fmt::format("\n{}: {}.", value.separator == ',' ? "Any of, between commas" : "One of",
                        fmt::join(choices, ", "));
  }
  if (!value.accepted.empty()) {
    text += fmt::format("\nAccepted: {}{}.", roff_text(value.accepted),
                        value.separator == ',' ? "; several between commas" : "");
  }
  if (!value.preset.empty()) {
    text += fmt::format("\nWithout it: {}.", bold(value.preset));
  }
  return text;
}

std::string entry(const std::string& heading, const std::string& body) {
  return fmt::format(".TP\n{}\n{}\n", heading, body);
}

std::string entry(const Option& option) {
  std::string body = sentence(option.description);
  if (option.has_value) {
    body += remarks_on(option.value);
  }
  if (!option.environment.empty()) {
    body += fmt::format("\nThe variable {} does the same.", bold(option.environment));
  }
  return entry(heading_of(option), body);
}

/// `verb --needed VALUE [options] POSITIONAL`
std::string synopsis_of(const Command& command, const std::string& path) {
  std::string text = bold(path);
  for (const Option& option : command.options) {
    if (option.required) {
      text += fmt::format(" {}", heading_of(option));
    }
  }
  text += fmt::format(" [{}]", italic("options"));
  for (const Positional& positional : command.positionals) {
    text += fmt::format(" {}{}", italic(positional.value.name), positional.repeats ? "..." : "");
  }
  return text;
}

/// Help is the same for all, and described once.
bool is_help(const Option& option) {
  return std::find(option.names.begin(), option.names.end(), "--help") != option.names.end();
}

std::string verb_sections(const Command& command, const std::string& path) {
  std::string text;
  for (const Command& verb : command.verbs) {
    const std::string name = path.empty() ? verb.name : path + " " + verb.name;
    if (!verb.verbs.empty()) {
      text += verb_sections(verb, name);
      continue;
    }
    text += fmt::format(".SS {}\n{}\n.PP\n{}\n", roff_literal(name), sentence(verb.description),
                        synopsis_of(verb, name));
    for (const Positional& positional : verb.positionals) {
      text += entry(italic(positional.value.name),
                    sentence(positional.description) + remarks_on(positional.value));
    }
    for (const Option& option : verb.options) {
      text += is_help(option) ? "" : entry(option);
    }
  }
  return text;
}

std::vector<std::string> all_examples(const Command& command) {
  std::vector<std::string> examples = examples_of(command.footer);
  for (const Command& verb : command.verbs) {
    const std::vector<std::string> more = all_examples(verb);
    examples.insert(examples.end(), more.begin(), more.end());
  }
  return examples;
}

std::string examples_section(const Command& program, const std::string& in_tree,
                             const std::string& installed) {
  std::vector<std::string> examples;
  for (const std::string& example : all_examples(program)) {
    examples.push_back(
        fmt::format(".EX\n{}\n.EE\n", roff_literal(replace_all(example, in_tree, installed))));
  }
  return fmt::format(".SH EXAMPLES\n{}", fmt::join(examples, ".PP\n"));
}

std::string head(const Command& program, const Release& release) {
  return fmt::format(
      ".\\\" Written by: {0} manual\n"
      ".TH {1} 1 \"{10}\" \"tendonlife {2}\" \"User Commands\"\n"
      ".SH NAME\n{3} \\- {4}\n"
      ".SH SYNOPSIS\n{5} {6} [{7}]\n.br\n{5} [{6}] {8}\n.br\n{5} {9}\n",
      program.name, upper_case(program.name), release.version, roff_literal(program.name),
      roff_text(program.description), bold(program.name), italic("verb"), italic("options"),
      bold("--help"), bold("--version"), release.date);
}

/// A line that begins with one of these is a request.
std::string guarded(const std::string& text) {
  const bool request = !text.empty() && (text.front() == '.' || text.front() == '\'');
  return request ? "\\&" + text : text;
}

bool in_a_word(char before) {
  return std::isalnum(static_cast<unsigned char>(before)) != 0;
}

}  // namespace

std::string manual_page(const Command& program, const Release& release, const ManualProse& prose,
                        const std::string& examples_in_tree,
                        const std::string& examples_installed) {
  std::string text = head(program, release);
  text += ".SH DESCRIPTION\n" + prose.description;
  text += ".SH OPTIONS\n";
  for (const Option& option : program.options) {
    text += entry(option);
  }
  text += ".SH VERBS\n" + verb_sections(program, "");
  text += prose.after_verbs;
  text += examples_section(program, examples_in_tree, examples_installed);
  return text + ".SH SEE ALSO\n" + prose.see_also;
}

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

std::vector<std::string> examples_of(const std::string& footer) {
  constexpr std::string_view kMark = "Example: ";
  const std::string indent(kMark.size(), ' ');
  std::vector<std::string> examples;
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);) {
    const bool first = line.rfind(kMark, 0) == 0;
    if (first || (!examples.empty() && line.rfind(indent, 0) == 0)) {
      examples.push_back(line.substr(kMark.size()));
    }
  }
  return examples;
}

}  // namespace host_sim::command_line
