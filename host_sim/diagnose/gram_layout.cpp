#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "host_sim/diagnose/gram.hpp"

namespace host_sim::diagnose {
namespace {

constexpr double kSamePose_rad = 0.0174532925199432958;  // a degree

double mean_of(const std::vector<double>& values) {
  return values.empty() ? 0
                        : std::accumulate(values.begin(), values.end(), 0.0) /
                              static_cast<double>(values.size());
}

/// What the first session that lacks something lacks; nothing is known without sessions.
std::string missing_in(std::span<const Session> sessions, const effects::TensionEffect& effect) {
  for (const Session& session : sessions) {
    if (std::string words = effect.missing(session.covariates); !words.empty()) {
      return words;
    }
  }
  return sessions.empty() ? "no recordings" : "";
}

void add_blocks(GramLayout& layout, std::span<const Session> sessions,
                const effects::Baseline& baseline, const std::vector<std::vector<double>>& shapes) {
  GramLayout::Effect& entry = layout.effects.back();
  const std::size_t effect = layout.effects.size() - 1;
  for (const std::vector<double>& shape : shapes) {
    const std::size_t count =
        entry.effect->signature(sessions.front().covariates, baseline, shape).columns.size();
    const std::size_t index = entry.blocks.size();
    for (std::size_t column = 0; column < count; ++column) {
      layout.columns.push_back({.kind = GramColumn::Kind::signature,
                                .effect = effect,
                                .shape = index,
                                .column = column});
    }
    entry.blocks.push_back({.shape = shape, .first = layout.size() - count, .count = count});
  }
}

void add_probe(GramLayout& layout, const Probe& probe) {
  const std::size_t index = layout.probes.size();
  layout.probes.push_back({.probe = probe, .first = layout.size()});
  for (std::size_t column = 0; column < probe.columns(); ++column) {
    layout.columns.push_back({.kind = GramColumn::Kind::probe, .effect = index, .column = column});
  }
}

}  // namespace

std::vector<Wanted> whole_catalogue(std::span<const std::string> without) {
  std::vector<Wanted> wanted;
  for (const auto& effect : effects::tension_effects()) {
    if (std::ranges::find(without, effect->id()) == without.end()) {
      wanted.push_back({.effect = effect.get(), .shapes = effect->shapes()});
    }
  }
  return wanted;
}

const GramLayout::Effect& GramLayout::of(std::string_view id) const {
  for (const Effect& entry : effects) {
    if (entry.effect->id() == id) {
      return entry;
    }
  }
  throw std::out_of_range("no effect of this id");
}

std::string GramLayout::label(std::size_t column) const {
  const GramColumn& what = columns.at(column);
  switch (what.kind) {
    case GramColumn::Kind::intercept:
      return "intercept";
    case GramColumn::Kind::friction:
      return "friction";
    case GramColumn::Kind::residual:
      return "residual";
    case GramColumn::Kind::probe:
      return std::string(name_of(probes[what.effect].probe.of)) + '[' +
             std::to_string(what.column) + ']';
    case GramColumn::Kind::signature:
      break;
  }
  std::string text(effects[what.effect].effect->id());
  text += '[';
  text += std::to_string(what.shape);
  text += "].";
  text += std::to_string(what.column);
  return text;
}

std::vector<double> poses_of(std::span<const Session> sessions) {
  std::vector<double> means;
  for (const Session& session : sessions) {
    if (session.covariates.samples() > 0) {
      means.push_back(mean_of(session.covariates.bend_angle_rad));
    }
  }
  std::ranges::sort(means);
  std::vector<double> poses;
  double last_rad = 0;
  for (const double mean_rad : means) {
    if (poses.empty() || mean_rad - last_rad > kSamePose_rad) {
      poses.push_back(mean_rad);
    }
    last_rad = mean_rad;
  }
  return poses;
}

GramLayout layout_of(std::span<const Session> sessions, const effects::Baseline& baseline,
                     const std::vector<Wanted>& wanted, const std::vector<Probe>& probes) {
  GramLayout layout;
  layout.columns.push_back({.kind = GramColumn::Kind::intercept});
  layout.columns.push_back({.kind = GramColumn::Kind::friction});
  for (const auto& [effect, shapes] : wanted) {
    layout.effects.push_back(
        {.effect = effect, .missing = missing_in(sessions, *effect), .blocks = {}});
    if (layout.effects.back().missing.empty()) {
      add_blocks(layout, sessions, baseline, shapes);
    }
  }
  for (const Probe& probe : probes) {
    add_probe(layout, probe);
  }
  layout.columns.push_back({.kind = GramColumn::Kind::residual});
  return layout;
}

}  // namespace host_sim::diagnose
