#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace host_sim {

/// A table whose first column names the rows and whose other columns are numbers. Texts are escaped
/// here.
class Table {
 public:
  Table(std::string_view label, std::initializer_list<std::string_view> columns);

  void row(std::string_view name, const std::vector<std::string>& cells);

  /// A row of running text, which may break into lines.
  void texts(std::string_view name, const std::vector<std::string>& cells);

  [[nodiscard]] std::string html() const;

 private:
  void add(std::string_view name, const std::vector<std::string>& cells,
           std::string_view attributes);

  std::string html_;
};

}  // namespace host_sim
