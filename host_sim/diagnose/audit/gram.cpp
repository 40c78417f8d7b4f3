#include "host_sim/diagnose/audit/gram.hpp"

#include <cmath>
#include <stdexcept>

#include "host_sim/statistics/parallel.hpp"

namespace host_sim::diagnose {
namespace {

using Eigen::Index;

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
                const effects::Baseline& baseline) {
  GramLayout::Effect& entry = layout.effects.back();
  for (const std::vector<double>& shape : entry.effect->shapes()) {
    const std::size_t count =
        entry.effect->signature(sessions.front().covariates, baseline, shape).columns.size();
    entry.blocks.push_back({.shape = shape, .first = layout.size, .count = count});
    layout.size += count;
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

Eigen::MatrixXd products_of(const Eigen::MatrixXd& columns) {
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(columns.cols(), columns.cols());
  gram.selfadjointView<Eigen::Lower>().rankUpdate(columns.transpose());
  gram.triangularView<Eigen::StrictlyUpper>() = gram.transpose();
  return gram;
}

}  // namespace

const GramLayout::Effect& GramLayout::of(std::string_view id) const {
  for (const Effect& entry : effects) {
    if (entry.effect->id() == id) {
      return entry;
    }
  }
  throw std::out_of_range("no effect of this id");
}

GramLayout layout_of(std::span<const Session> sessions, const effects::Baseline& baseline) {
  GramLayout layout;
  for (const auto& effect : effects::tension_effects()) {
    layout.effects.push_back(
        {.effect = effect.get(), .missing = missing_in(sessions, *effect), .blocks = {}});
    if (layout.effects.back().missing.empty()) {
      add_blocks(layout, sessions, baseline);
    }
  }
  return layout;
}

Eigen::MatrixXd columns_of(const Session& session, const GramLayout& layout,
                           const effects::Baseline& baseline) {
  const recording::Covariates& covariates = session.covariates;
  Eigen::MatrixXd columns(static_cast<Index>(covariates.samples()),
                          static_cast<Index>(layout.size));
  for (std::size_t i = 0; i < covariates.samples(); ++i) {
    const auto row = static_cast<Index>(i);
    columns(row, Index{GramLayout::kIntercept}) = 1;
    columns(row, Index{GramLayout::kFriction}) =
        -covariates.bend_angle_rad[i] * covariates.direction[i];
  }
  for (const GramLayout::Effect& entry : layout.effects) {
    for (const GramLayout::Block& block : entry.blocks) {
      fill_block(columns, block, entry.effect->signature(covariates, baseline, block.shape));
    }
  }
  return columns;
}

Grams gram_of(std::span<const Session> sessions, const GramOptions& options) {
  Grams grams{.baseline = options.baseline, .layout = {}, .sessions = {}};
  if (grams.baseline.poses_rad.empty()) {
    grams.baseline.poses_rad = poses_of(sessions);
  }
  grams.layout = layout_of(sessions, grams.baseline);
  grams.sessions.resize(sessions.size());
  statistics::parallel_for(
      sessions.size(),
      [&](std::size_t i) {
        Eigen::MatrixXd columns = columns_of(sessions[i], grams.layout, grams.baseline);
        whiten(columns, options.autocorrelation);
        grams.sessions[i] = products_of(columns);
      },
      options.threads);
  return grams;
}

}  // namespace host_sim::diagnose
