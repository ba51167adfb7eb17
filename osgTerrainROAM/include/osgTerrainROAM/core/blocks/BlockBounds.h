// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include <glm/glm.hpp>

#include <viewlod/Frustum.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/blocks/BlockGrid.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// A box along the axes of the tile's frame around everything that a block can draw. Units: metres.
struct BlockBox
{
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

    void include(const glm::dvec3& point)
    {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    glm::dvec3 centre() const { return (low + high) * 0.5; }

    /// No point of it is nearer.
    double distanceM(const glm::dvec3& point) const
    {
        return glm::length(glm::max(glm::max(low - point, point - high), glm::dvec3(0.0)));
    }

    bool mayBeSeen(const viewlod::Frustum& frustum) const
    {
        for (int i = 0; i < viewlod::Frustum::kPlanes; ++i)
        {
            const glm::dvec4& plane = frustum.planes()[static_cast<std::size_t>(i)];
            const glm::dvec3 farthest(plane.x > 0.0 ? high.x : low.x, plane.y > 0.0 ? high.y : low.y,
                                      plane.z > 0.0 ? high.z : low.z);
            if (frustum.signedDistance(i, farthest) < 0.0) return false;
        }
        return true;
    }
};

/// The error that a block may have for each pixel of tolerance: K e / max(d, n) <= tolerance, with d the
/// least distance from the eye to the box (viewlod::screenErrorBoundPx).
inline double allowedErrorM(const BlockBox& box, const viewlod::ViewState& view)
{
    return std::max(box.distanceM(view.eyeWorld), view.nearM) / view.guaranteedPixelsPerTangent();
}

/// Bounds a block by all its points of the grid.
BlockBox boundBlock(const PlacedTile& tile, const BlockGrid& grid, std::uint32_t block);

} // namespace osgTerrainROAM::core
