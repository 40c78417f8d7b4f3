#include "host_sim/report/replay/loop.hpp"

#include <fmt/format.h>

#include <utility>

#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/number_text.hpp"
#include "host_sim/report/page/stretch.hpp"

namespace host_sim {

Chart loop_chart(const ReplayReport& report) {
  constexpr int kHeads = 4;
  Chart chart;
  chart.id = "loop";
  chart.name = "Loop of input and output tension";
  chart.x = {"Input tension, N", Axis::Kind::linear, "N", {}, false};
  chart.y = {"Output tension, N", Axis::Kind::linear, "N", {}, false};
  if (!report.loop.time_s.empty()) {
    const std::vector<std::size_t> gaps = gaps_in(report.loop.time_s);
    Layer line;
    line.width_px = 1.5;
    line.heads = kHeads;
    line.x = with_gaps(report.loop.input_N, gaps);
    line.y = with_gaps(report.loop.output_N, gaps);
    chart.layers.push_back(std::move(line));
  }
  return chart;
}

namespace sections {

std::string loop(const ReplayReport& report) {
  const std::vector<double>& time_s = report.loop.time_s;
  if (time_s.empty()) {
    return {};
  }
  return elements::chart(
      loop_chart(report),
      fmt::format("From {} to {}: the output tension as it was measured over the input tension "
                  "that the model makes of it. The width of the loop is the friction.",
                  quantity_text(time_s.front(), "s", 4), quantity_text(time_s.back(), "s", 4)),
      "");
}

}  // namespace sections
}  // namespace host_sim
