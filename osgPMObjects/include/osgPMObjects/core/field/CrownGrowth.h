// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/field/LevelLadder.h>

namespace osgPMObjects::core
{

/// How the leaf cards that are left on a rung grow about their middles for those that are gone, so that a crown from far away looks as dense as
/// from near by. Levels of a progressive mesh keep places of vertices, so it is the vertex shader that moves them.
/// Without foliage both are empty. Memory: 12 B a wedge.
/// Source: Cook, Halstead, Planck & Ryu, "Stochastic simplification of aggregate detail" (2007), §3.2, for random subsets.
/// Differs: areas that are measured, what the simplification has kept, and `kShare`.
struct CrownGrowth
{
    /// The logarithm of the area that is given back, of that which is lost: cards that are gone were partly behind others, and those that are left
    /// are the outer ones. 0.4 has the least error of 0, 0.2 … 1 in pictures (docs/algorithms/fields.md).
    static constexpr double kShare = 0.4;
    static constexpr float kMost = 5.0f;

    std::vector<glm::vec3> offsets; ///< by wedge: from the middle of its card; 0 of what is no leaf
    std::vector<float> scales;      ///< by rung and group: of offsets; 1 where there is nothing to grow

    static CrownGrowth of(const ProgressiveMesh& progressive, const LevelLadder& ladder);
};

} // namespace osgPMObjects::core
