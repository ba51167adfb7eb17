// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/field/LevelLadder.h>

namespace osgPMObjects::core
{

/// The growth of the leaf cards that are left on a rung. Cards grow about their centres to replace those that
/// are gone, so that a distant crown looks as dense as a near one. The vertex shader applies it, for all
/// levels of a progressive mesh share their vertices. Without foliage both arrays are empty. Memory: 12 B a
/// wedge.
/// Source: Cook, Halstead, Planck & Ryu, "Stochastic simplification of aggregate detail" (2007), §3.2, for
/// random subsets.
/// Differs: the lost area is measured on the cards that the simplification kept; `kShare`.
struct CrownGrowth
{
    /// The share of the lost area that growth restores, in the logarithm of the area. It is below 1 because
    /// lost cards were partly hidden, and the cards left are the outer ones. Of 0, 0.2 … 1 it has the least
    /// image error (docs/algorithms/fields.md).
    static constexpr double kShare = 0.4;
    static constexpr float kMost = 5.0f; ///< the largest scale of a card

    std::vector<glm::vec3>
        offsets; ///< by wedge: from its card's centre, in the model's units; 0 for other surfaces
    std::vector<float> scales; ///< by rung and group: factor of the offsets, 1 … kMost

    /// Measures the growth of every rung. `ladder`: of the same mesh. Cost: linear in the faces of all rungs.
    static CrownGrowth of(const ProgressiveMesh& progressive, const LevelLadder& ladder);
};

} // namespace osgPMObjects::core
