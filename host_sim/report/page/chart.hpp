#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace host_sim {

/// One axis of a chart. Values of a log axis are above 0; those of a Weibull axis are shares
/// between 0 and 1, drawn at ln(-ln(1 - p)) and labelled in percent; on an axis of categories the
/// value i stands under the i-th label.
struct Axis {
  enum class Kind { linear, log, weibull, category };
  std::string label;
  Kind kind = Kind::linear;
  std::string unit;                     ///< for the reading line; may be empty
  std::vector<std::string> categories;  ///< lines of a label are divided by a line feed
  bool from_zero = false;               ///< a linear axis from 0; in per cent y is a share
};

/// What is drawn on top of each other, in order. A layer without a name is not in the legend.
/// Values that are not finite are left out, but for the ends of bars: an infinite end reaches the
/// rim.
struct Layer {
  enum class Kind {
    line,
    area,    ///< inside the outline through x, y
    points,  ///< each can be read by pointer and by keyboard
    bars,    ///< vertical, from y to high, with caps
    rug,     ///< short strokes at the foot of the chart
    labels,  ///< texts at x, y
  };
  enum class Arrow { none, up, right };

  Kind kind = Kind::line;
  std::string name;
  std::string colour = "line";        ///< of the style sheet, without the leading dashes
  std::string_view shape = "circle";  ///< of points: circle, square, triangle, diamond, star, cross
  bool filled = true;                 ///< points
  bool dashed = false;                ///< lines
  double width_px = 2;                ///< lines and bars
  int heads = 0;                      ///< of arrows along a line, from its first to its last point
  Arrow arrow = Arrow::none;          ///< of points: the value lies beyond
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> high;        ///< bars
  std::vector<std::string> texts;  ///< labels; of points and bars, what to read; may be empty
};

struct Chart {
  std::string id;    ///< letters, digits and hyphens, unique in a page
  std::string name;  ///< for screen readers
  Axis x;
  Axis y;
  std::vector<Layer> layers;
};

/// What the page's script draws a chart from.
[[nodiscard]] nlohmann::json chart_json(const Chart& chart);

}  // namespace host_sim
