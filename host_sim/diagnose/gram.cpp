#include "host_sim/diagnose/gram.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "host_sim/statistics/parallel.hpp"

namespace host_sim::diagnose {
namespace {

/// What the first session that lacks something lacks; nothing is known without sessions.
std::string missing_in(std::span<const Session> sessions, const effects::TensionEffect& effect) {
  for (const Session& session : sessions) {
    if (std::string text = effect.missing(session.covariates); !text.empty()) {
      return text;
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
      layout.columns.push_back(
          {.kind = ColumnKind::signature, .effect = effect, .shape = index, .column = column});
    }
    entry.blocks.push_back({.shape = shape, .first = layout.size() - count, .count = count});
  }
}

void add_probe(GramLayout& layout, const Probe& probe) {
  const std::size_t index = layout.probes.size();
  layout.probes.push_back({.probe = probe, .first = layout.size()});
  for (std::size_t column = 0; column < probe.columns(); ++column) {
    layout.columns.push_back({.kind = ColumnKind::probe, .effect = index, .column = column});
  }
}

using Eigen::Index;

/// Of the noise of ln T_out/T_in: noise in newtons that has no mean lowers the logarithm by half
/// its variance.
double mean_of_noise(const recording::Covariates& covariates, std::size_t i) {
  return covariates.input_noise.empty()
             ? 0
             : (covariates.input_noise[i] - covariates.output_noise[i]) / 2;
}

void fill_baseline(Eigen::MatrixXd& columns, const recording::Covariates& covariates,
                   const GramLayout& layout, double friction_coefficient) {
  const std::vector<double>& input_N = covariates.tension_in_N();
  const auto residual = static_cast<Index>(layout.residual());
  for (std::size_t i = 0; i < covariates.samples(); ++i) {
    const auto row = static_cast<Index>(i);
    const double angle = covariates.bend_angle_rad[i] * covariates.direction[i];
    columns(row, Index{GramLayout::kIntercept}) = 1;
    columns(row, Index{GramLayout::kFriction}) = -angle;
    columns(row, residual) = std::log(covariates.output_tension_N[i] / input_N[i]) +
                             friction_coefficient * angle - mean_of_noise(covariates, i);
  }
}

void fill_block(Eigen::MatrixXd& columns, const GramLayout::Block& block,
                const effects::Signature& signature) {
  if (signature.columns.size() != block.count) {
    throw std::logic_error("an effect has another number of columns than its layout");
  }
  for (std::size_t column = 0; column < block.count; ++column) {
    const std::vector<double>& values = signature.columns[column];
    if (static_cast<Index>(values.size()) != columns.rows()) {
      throw std::logic_error("a signature has another number of samples than its session");
    }
    columns.col(static_cast<Index>(block.first + column)) =
        Eigen::Map<const Eigen::VectorXd>(values.data(), columns.rows());
  }
}

void fill_probe(Eigen::MatrixXd& columns, const GramLayout::ProbeBlock& block,
                const recording::Covariates& covariates) {
  columns.middleCols(static_cast<Index>(block.first), static_cast<Index>(block.probe.columns()))
      .setZero();
  const std::vector<std::size_t> places = block.probe.column_of(covariates);
  for (std::size_t i = 0; i < places.size(); ++i) {
    columns(static_cast<Index>(i), static_cast<Index>(block.first + places[i])) = 1;
  }
}

void whiten(Eigen::MatrixXd& columns, double autocorrelation) {
  if (autocorrelation == 0 || columns.rows() == 0) {
    return;
  }
  for (Index column = 0; column < columns.cols(); ++column) {
    double* const values = columns.col(column).data();
    for (Index row = columns.rows() - 1; row > 0; --row) {
      values[row] -= autocorrelation * values[row - 1];
    }
  }
  columns.row(0) *= std::sqrt(1 - autocorrelation * autocorrelation);
}

double mean_bend_angle(const recording::Covariates& covariates) {
  double sum_rad = 0;
  for (const double angle_rad : covariates.bend_angle_rad) {
    sum_rad += angle_rad;
  }
  return covariates.samples() == 0 ? 0 : sum_rad / static_cast<double>(covariates.samples());
}

/// Where another Gram has each column of a layout.
class KnownColumns {
 public:
  KnownColumns(const GramLayout& layout, const effects::Baseline& baseline, const Grams& known) {
    const bool same_baseline = known.baseline == baseline;
    for (std::size_t column = 0; column < layout.size(); ++column) {
      const GramColumn& what = layout.columns[column];
      const Index place = same_baseline || !is_of_baseline(what.kind)
                              ? place_in(known.layout, layout, what)
                              : kNone;
      auto& own = place == kNone ? new_ : known_;
      own.push_back(static_cast<Index>(column));
      if (place != kNone) {
        places_.push_back(place);
      }
    }
  }

  /// The Gram matrix of columns of which `known` is that of another layout.
  [[nodiscard]] Eigen::MatrixXd gram(const Eigen::MatrixXd& columns,
                                     const Eigen::MatrixXd& known) const {
    Eigen::MatrixXd gram(columns.cols(), columns.cols());
    gram(known_, known_) = known(places_, places_);
    const Eigen::MatrixXd products = columns.transpose() * columns(Eigen::all, new_);
    gram(Eigen::all, new_) = products;
    gram(new_, Eigen::all) = products.transpose();
    return gram;
  }

 private:
  static constexpr Index kNone = -1;

  static bool is_of_baseline(ColumnKind kind) {
    return kind == ColumnKind::signature || kind == ColumnKind::residual;
  }

  static Index place_in(const GramLayout& known, const GramLayout& layout,
                        const GramColumn& column) {
    switch (column.kind) {
      case ColumnKind::intercept:
        return Index{GramLayout::kIntercept};
      case ColumnKind::friction:
        return Index{GramLayout::kFriction};
      case ColumnKind::residual:
        return static_cast<Index>(known.residual());
      case ColumnKind::probe:
        return place_of(known, layout.probes[column.effect].probe, column.column);
      case ColumnKind::signature:
        break;
    }
    const GramLayout::Effect& wanted = layout.effects[column.effect];
    for (const GramLayout::Effect& entry : known.effects) {
      for (const GramLayout::Block& block : entry.blocks) {
        if (entry.effect == wanted.effect && block.shape == wanted.blocks[column.shape].shape) {
          return static_cast<Index>(block.first + column.column);
        }
      }
    }
    return kNone;
  }

  static Index place_of(const GramLayout& known, const Probe& probe, std::size_t column) {
    const auto block = std::ranges::find(known.probes, probe, &GramLayout::ProbeBlock::probe);
    return block == known.probes.end() ? kNone : static_cast<Index>(block->first + column);
  }

  std::vector<Index> known_;   ///< columns that the other has
  std::vector<Index> places_;  ///< where it has them
  std::vector<Index> new_;
};

Eigen::MatrixXd gram_of_all(const Eigen::MatrixXd& columns) {
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(columns.cols(), columns.cols());
  gram.selfadjointView<Eigen::Lower>().rankUpdate(columns.transpose());
  gram.triangularView<Eigen::StrictlyUpper>() = gram.transpose();
  return gram;
}

/// The columns of a session, weighed and whitened.
Eigen::MatrixXd white_columns(const Session& session, const Grams& grams,
                              const GramOptions& options, std::size_t place) {
  Eigen::MatrixXd columns = columns_of(session, grams.layout, grams.baseline,
                                       options.kept ? &options.kept->of(place) : nullptr);
  if (!options.weights.empty()) {
    weigh(columns, options.weights[place]);
  }
  whiten(columns, options.autocorrelation);
  return columns;
}

double log_weights_of(const GramOptions& options, std::size_t place) {
  double sum = 0;
  if (!options.weights.empty()) {
    for (const double weight : options.weights[place]) {
      sum += std::log(weight);
    }
  }
  return sum;
}

std::size_t bytes_of(const effects::Signature& signature) {
  std::size_t bytes = 0;
  for (const std::vector<double>& column : signature.columns) {
    bytes += column.size() * sizeof(double);
  }
  return bytes;
}

}  // namespace

const effects::Signature& KeptSignatures::OfSession::signature(const Session& session,
                                                               const effects::TensionEffect& effect,
                                                               const effects::Baseline& baseline,
                                                               const std::vector<double>& shape,
                                                               effects::Signature& room) {
  if (baseline != baseline_) {
    forget();
    baseline_ = baseline;
  }
  for (const Kept& kept : kept_) {
    if (kept.effect == &effect && kept.signature->shape == shape) {
      return *kept.signature;
    }
  }
  room = effect.signature(session.covariates, baseline, shape);
  const std::size_t bytes = bytes_of(room);
  std::size_t left = *bytes_left_;
  while (left >= bytes && !bytes_left_->compare_exchange_weak(left, left - bytes)) {
  }
  if (left < bytes) {
    return room;
  }
  kept_.push_back({&effect, std::make_unique<const effects::Signature>(std::move(room))});
  return *kept_.back().signature;
}

void KeptSignatures::OfSession::forget() {
  for (const Kept& kept : kept_) {
    *bytes_left_ += bytes_of(*kept.signature);
  }
  kept_.clear();
}

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
    case ColumnKind::intercept:
      return "intercept";
    case ColumnKind::friction:
      return "friction";
    case ColumnKind::residual:
      return "residual";
    case ColumnKind::probe:
      return std::string(name_of(probes[what.effect].probe.of)) + '[' +
             std::to_string(what.column) + ']';
    case ColumnKind::signature:
      break;
  }
  std::string text(effects[what.effect].effect->id());
  text += '[';
  text += std::to_string(what.shape);
  text += "].";
  text += std::to_string(what.column);
  return text;
}

GramLayout layout_of(std::span<const Session> sessions, const effects::Baseline& baseline,
                     const std::vector<Wanted>& wanted, const std::vector<Probe>& probes) {
  GramLayout layout;
  layout.columns.push_back({.kind = ColumnKind::intercept});
  layout.columns.push_back({.kind = ColumnKind::friction});
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
  layout.columns.push_back({.kind = ColumnKind::residual});
  return layout;
}

void weigh(Eigen::MatrixXd& columns, const std::vector<double>& weights) {
  if (static_cast<Index>(weights.size()) != columns.rows()) {
    throw std::logic_error("weights have another number of samples than their session");
  }
  const Eigen::ArrayXd roots =
      Eigen::Map<const Eigen::ArrayXd>(weights.data(), columns.rows()).sqrt();
  columns.array().colwise() *= roots;
}

double Grams::samples() const {
  double sum = 0;
  for (const SessionGram& session : sessions) {
    sum += static_cast<double>(session.samples);
  }
  return sum;
}

Eigen::MatrixXd columns_of(const Session& session, const GramLayout& layout,
                           const effects::Baseline& baseline, KeptSignatures::OfSession* kept) {
  Eigen::MatrixXd columns(static_cast<Index>(session.covariates.samples()),
                          static_cast<Index>(layout.size()));
  fill_baseline(columns, session.covariates, layout, baseline.friction_coefficient);
  for (const GramLayout::Effect& entry : layout.effects) {
    for (const GramLayout::Block& block : entry.blocks) {
      effects::Signature room;
      if (kept != nullptr) {
        fill_block(columns, block,
                   kept->signature(session, *entry.effect, baseline, block.shape, room));
      } else {
        fill_block(columns, block,
                   entry.effect->signature(session.covariates, baseline, block.shape));
      }
    }
  }
  for (const GramLayout::ProbeBlock& block : layout.probes) {
    fill_probe(columns, block, session.covariates);
  }
  return columns;
}

Grams gram_of(std::span<const Session> sessions, const GramOptions& options, const Grams* known) {
  if (!options.weights.empty() && options.weights.size() != sessions.size()) {
    throw std::logic_error("weights of another number of sessions");
  }
  Grams grams{.baseline = options.baseline, .layout = {}, .sessions = {}};
  if (grams.baseline.poses_rad.empty()) {
    grams.baseline.poses_rad = poses_of(sessions);
  }
  grams.layout = layout_of(sessions, grams.baseline, options.wanted, options.probes);
  grams.sessions.resize(sessions.size());
  std::optional<KnownColumns> in_known;
  if (known != nullptr) {
    in_known.emplace(grams.layout, grams.baseline, *known);
  }
  statistics::parallel_for(
      sessions.size(),
      [&](std::size_t i) {
        const Session& session = sessions[i];
        const Eigen::MatrixXd columns = white_columns(session, grams, options, i);
        grams.sessions[i] = {.session = session.name,
                             .gram = in_known ? in_known->gram(columns, known->sessions[i].gram)
                                              : gram_of_all(columns),
                             .samples = session.covariates.samples(),
                             .bend_angle_rad = mean_bend_angle(session.covariates),
                             .log_weights = log_weights_of(options, i)};
      },
      options.threads);
  return grams;
}

}  // namespace host_sim::diagnose
