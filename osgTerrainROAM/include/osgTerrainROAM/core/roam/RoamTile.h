// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unordered_map>

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
/// Threads: immutable after construction. Memory: that of the placed tile, 32 B per culling node, and some bytes for each
/// vertex beyond the data's edge that triangles across the edge split at.
class RoamTile
{
public:
    explicit RoamTile(PlacedTile placedTile);

    /// Of the bintree vertex at a place of the grid.
    SplitBound bound(GridPoint v) const
    {
        if (!tile.isInData(v.column, v.row)) return boundBeyond(v);
        const SampleTable::Sample sample = tile.samples().sample(indexInData(v));
        return {glm::vec3(tile.positionOf(v.column, v.row, sample.heightM)), sample.errorM, sample.radiusM};
    }

    float errorM(GridPoint v) const
    {
        return tile.isInData(v.column, v.row) ? tile.samples().sample(indexInData(v)).errorM
                                              : boundBeyond(v).errorM;
    }

    /// Tells the processor that bound(v) will be asked for.
    void prefetch(GridPoint v) const
    {
        if (tile.isInData(v.column, v.row)) tile.samples().prefetch(indexInData(v));
    }

    PlacedTile tile;
    RegionBounds regions;
    HidingGround hidingGround;

private:
    struct Bound
    {
        float errorM, radiusM;
    };

    std::size_t indexInData(GridPoint v) const
    {
        return static_cast<std::size_t>(v.row) * static_cast<std::size_t>(tile.dataColumns()) +
               static_cast<std::size_t>(v.column);
    }

    SplitBound boundBeyond(GridPoint v) const;

    std::unordered_map<SampleIndex, Bound> _beyond; ///< only those that have an error
};

} // namespace osgTerrainROAM::core
