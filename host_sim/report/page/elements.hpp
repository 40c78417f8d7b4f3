#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/report/page/chart.hpp"

namespace host_sim {

/// Text that is safe in HTML content and in quoted attributes. Bytes that are not UTF-8 and control
/// characters other than tab and line feed become U+FFFD.
[[nodiscard]] std::string html_escape(std::string_view text);

/// One line of ASCII JSON that is safe inside a script element: no character can end the element or
/// start a comment. Non-finite numbers become null; bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string script_json(const nlohmann::json& value);

/// A table whose first column names the rows. Texts are escaped here.
class Table {
 public:
  /// Numbers stand to the right and stay in one line; texts stand to the left and may break.
  enum class Cells { numbers, texts };

  Table(std::string_view label, std::initializer_list<std::string_view> columns,
        Cells cells = Cells::numbers);

  void row(std::string_view name, const std::vector<std::string>& cells);

  [[nodiscard]] std::string html() const;

 private:
  std::string_view cell_attributes_;
  std::string html_;
};

}  // namespace host_sim

/// Parts of a page as HTML; their texts are escaped here.
namespace host_sim::elements {

/// A key number with its name and a note, for a list of class tiles.
[[nodiscard]] std::string tile(std::string_view name, std::string_view value,
                               std::string_view note);

/// In the place of a plot that has nothing to show: why.
[[nodiscard]] std::string empty(std::string_view reason);

/// The place of a chart that the script of this id draws; `name` and `summary` are what a screen
/// reader says.
[[nodiscard]] std::string chart_place(std::string_view id, std::string_view name,
                                      std::string_view summary);

/// The warnings as a section of their own; empty without any.
[[nodiscard]] std::string warnings(const std::vector<std::string>& warnings);

/// Sentences as a list.
[[nodiscard]] std::string words(const std::vector<std::string>& sentences);

/// What to see in a chart, and its place; or why there is nothing to see.
[[nodiscard]] std::string chart(const Chart& chart, std::string_view caption,
                                std::string_view why_empty);

/// The table where there are rows for it, else why there are none.
[[nodiscard]] std::string table_or(bool has_rows, const std::string& table,
                                   std::string_view why_empty);

}  // namespace host_sim::elements
