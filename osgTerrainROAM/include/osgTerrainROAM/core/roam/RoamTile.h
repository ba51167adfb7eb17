// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/ErrorTree.h>
#include <osgTerrainROAM/core/roam/RegionBounds.h>

namespace osgTerrainROAM::core
{

/// What the refinement predicate needs of a split vertex.
struct SplitBound
{
    glm::vec3 centre{0.0f}; ///< X_v, rounded to float; the radius has the rounding included
    float errorM =
        0.0f; ///< e_v: no sample in the vertex's diamond, nor in any below, is farther from its plane
    float radiusM = 0.0f; ///< r_v: all split vertices below lie within
};

/// What all views of one terrain tile share: samples, positions, bounds.
/// Threads: immutable after construction.
struct RoamTile
{
    explicit RoamTile(PlacedTile placedTile) : tile(std::move(placedTile)), errors(tile), regions(tile) {}

    SplitBound bound(GridPoint v) const
    {
        const SampleIndex index = static_cast<SampleIndex>(v.row) * static_cast<SampleIndex>(tile.side()) +
                                  static_cast<SampleIndex>(v.column);
        return {glm::vec3(tile.position(v.column, v.row)), errors.errorM(index), errors.radiusM(index)};
    }

    PlacedTile tile;
    ErrorTree errors;
    RegionBounds regions;
};

} // namespace osgTerrainROAM::core
