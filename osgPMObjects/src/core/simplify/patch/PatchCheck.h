// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "../quadric/StarQuadric.h"
#include "WedgePlan.h"

namespace osgPMObjects::core
{

/// The faces around `star.middle` without those at `besides`, when the middle has gone to `to`: the patch that takes the place
/// of the star.
struct Patch
{
    const Star& star;
    std::span<const glm::dvec3> positions;
    std::uint32_t besides = 0;
    glm::dvec3 to;
};

/// Whether a face of the patch would turn over, or become a needle that it is not now.
/// Source: Garland and Heckbert (1997), §4.3 (inversions), with a limit below a right angle.
bool foldsOver(const Patch& patch);

/// How far the middle is from the patch, and how much else it looks there.
struct PatchGap
{
    LevelError gap;
    /// The weighted squared length by which what is seen has slipped: texture along the surface; normals and colours as shares of
    /// the way that the middle goes.
    double slipCost = 0.0;
};

/// What a mesh's faces are drawn with, as a collapse finds them.
struct Look
{
    const Mesh& mesh;
    const StarMesh& stars;
    AreaWeight weight;
};

/// Looks for the place of the patch that is nearest to where the middle was, for each group of faces that share a wedge there,
/// and compares.
PatchGap gapOf(const Patch& patch, std::span<const WedgeChange> changes, const Look& look);

/// Only the distance. Cost: some 50 ns a face.
float distanceFrom(const Patch& patch);

} // namespace osgPMObjects::core
