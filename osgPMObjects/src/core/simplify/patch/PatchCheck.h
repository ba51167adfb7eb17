// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "../quadric/StarQuadric.h"
#include "WedgePlan.h"

namespace osgPMObjects::core
{

/// The faces that replace a star when its middle merges into `to`: those of the star except the faces at
/// `besides`.
struct Patch
{
    const Star& star;
    std::span<const glm::dvec3> positions;
    std::uint32_t besides = 0;
    glm::dvec3 to;
};

/// The change of a patch's faces.
struct PatchTurn
{
    bool foldsOver = false;  ///< a face turns over, or becomes a needle that it is not now
    double doubleArea = 0.0; ///< change of twice their area; not computed where a face folds over
};

/// Computes how a collapse turns and stretches the faces of a patch.
/// Source: Garland and Heckbert, *Surface simplification using quadric error metrics* (1997), section 4.3
/// (inversions).
/// Differs: the limit is below a right angle.
PatchTurn turnOf(const Patch& patch);

inline bool foldsOver(const Patch& patch)
{
    return turnOf(patch).foldsOver;
}

/// The distance of the removed position from the patch, and the difference in appearance there.
struct PatchGap
{
    LevelError gap;
    /// Weighted squared displacement of appearance: of the texture along the surface; of normals and colours
    /// as shares of the way that the position moves.
    double slipCost = 0.0;
    double lengthPerTexture = 0.0; ///< on the surface, of a unit of texture coordinates: the largest
};

/// The attributes and materials of the faces that a collapse changes.
struct Look
{
    const Mesh& mesh;
    const StarMesh& stars;
    AreaWeight weight;
};

/// Computes the gap at the point of the patch nearest to the removed position, for each group of faces that
/// share a wedge there.
PatchGap gapOf(const Patch& patch, std::span<const WedgeChange> changes, const Look& look);

/// Computes the distance only. Cost: some 50 ns a face.
float distanceFrom(const Patch& patch);

} // namespace osgPMObjects::core
