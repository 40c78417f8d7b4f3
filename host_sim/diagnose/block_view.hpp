#pragma once

#include <Eigen/Core>
#include <vector>

#include "host_sim/diagnose/projection.hpp"

namespace host_sim::diagnose {

/// One shape of an effect as the campaign shows it, its columns at their typical size.
struct BlockView {
  Eigen::Index first = 0, count = 0;
  Eigen::VectorXd typical;  ///< size of each column
  double share = 0;         ///< see EffectAudit
  double sigmas = 0;
  double sigmas_at_bound = 0;
  /// Takes the columns to an orthonormal base of what is left of them, count x rank.
  Eigen::MatrixXd base;
};

BlockView view_of(const GramLayout::Effect& effect, const GramLayout::Block& block,
                  const Projection& projection);

/// The place of the block whose shape is nearest to the typical one, relative to the bounds.
std::size_t typical_block(const GramLayout::Effect& effect);

struct Likeness {
  double cosine = 0;
  double canonical = 0;
};

/// See PairAudit.
Likeness likeness_of(const BlockView& one, const BlockView& other, const Projection& projection);

}  // namespace host_sim::diagnose
