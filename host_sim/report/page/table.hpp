#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace host_sim {

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
