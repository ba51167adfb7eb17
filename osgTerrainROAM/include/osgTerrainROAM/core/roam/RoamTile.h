// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <shared_mutex>
#include <unordered_map>
#include <unordered_set>
#include <vector>

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

/// What an edit has changed, for meshes that follow.
struct TileChange
{
    std::vector<GridPoint> vertices; ///< whose bounds are others now
    std::vector<GridRect> moved;     ///< places that may lie elsewhere
};

/// What all views of one terrain tile share: samples, positions, bounds.
/// Threads: any may read while they hold a lock of mutex() that is shared; who edits (TileEditor) holds it alone. A tile
/// that is never edited needs none. Memory: that of the placed tile, 32 B per culling node, and some bytes for each
/// vertex beyond the data's edge that triangles across the edge split at.
class RoamTile
{
public:
    explicit RoamTile(PlacedTile placedTile);

    /// Of the bintree vertex at a place of the grid.
    SplitBound bound(GridPoint v) const
    {
        if (!tile.grid().isInData(v.column, v.row)) return boundBeyond(v);
        const SampleTable::Sample sample = tile.samples().sample(v.column, v.row);
        return {glm::vec3(tile.frame().positionOf(v.column, v.row, sample.heightM)), sample.errorM,
                sample.radiusM};
    }

    float errorM(GridPoint v) const
    {
        return tile.grid().isInData(v.column, v.row) ? tile.samples().sample(v.column, v.row).errorM
                                                     : boundBeyond(v).errorM;
    }

    /// Tells the processor that bound(v) will be asked for.
    void prefetch(GridPoint v) const
    {
        if (tile.grid().isInData(v.column, v.row)) tile.samples().prefetch(v.column, v.row);
    }

    /// What can be kept of an error or a radius at a vertex: the least value that is not less. Keeps such.
    float roundedUpError(GridPoint v, double errorM) const;
    float roundedUpRadius(GridPoint v, double radiusM) const;
    void setBound(GridPoint v, float errorM, float radiusM);

    /// All that is kept at a place of the grid; to put it back.
    struct Memo
    {
        TileSamples::Kept kept;
        float errorBeyondM = 0.0f, radiusBeyondM = 0.0f;
    };
    Memo memo(GridPoint v) const;
    void restore(GridPoint v, const Memo& memo);

    /// Widens what culls to hold a place as it is now.
    void include(GridPoint v);

    /// Vertices whose errors are bounds that could be less (BoundsUpdate).
    std::vector<GridPoint> looseVertices() const;
    void setLoose(GridPoint v, bool loose);

    /// Edits so far, and what each has changed: meshes follow from where they are. None: it is too long ago.
    std::uint64_t revision() const { return _revision; }
    std::optional<std::vector<const TileChange*>> changesSince(std::uint64_t revision) const;
    void note(TileChange change);

    std::shared_mutex& mutex() const { return _mutex; }

    PlacedTile tile;
    RegionBounds regions;
    HidingGround hidingGround;

private:
    struct Bound
    {
        float errorM, radiusM;
    };

    static std::uint64_t keyOf(GridPoint v)
    {
        return static_cast<std::uint64_t>(v.row) << 32 | static_cast<std::uint64_t>(v.column);
    }

    SplitBound boundBeyond(GridPoint v) const;
    void admitSheets();

    static constexpr std::size_t kMostNoted = 1 << 20; ///< vertices and rectangles

    std::unordered_map<std::uint64_t, Bound> _beyond; ///< only those that have an error
    std::unordered_set<std::uint64_t> _loose;
    std::deque<TileChange> _changes; ///< the last of them leads to _revision
    std::size_t _noted = 0;
    std::uint64_t _revision = 0;
    mutable std::shared_mutex _mutex;
};

} // namespace osgTerrainROAM::core
