// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <shared_mutex>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <foundation/ContentMark.h>
#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/ErrorTree.h>
#include <osgTerrainROAM/core/roam/RegionBounds.h>

namespace foundation
{
class KeptResults;
}

namespace osgTerrainROAM::core
{

/// The bounds of a split vertex that the refinement predicate needs.
struct SplitBound
{
    glm::vec3 centre{0.0f}; ///< X_v, rounded to float; the radius has the rounding included
    float errorM =
        0.0f; ///< e_v: largest distance of a sample, in the vertex's diamond or below, from its plane
    float radiusM = 0.0f; ///< r_v: all split vertices below lie within
};

/// The changes of one edit, for meshes that follow it.
struct TileChange
{
    std::vector<GridPoint> vertices; ///< whose bounds have changed
    std::vector<GridRect> moved;     ///< rectangles of points that may have moved
};

/// The part of a terrain tile that all its views share: samples, positions, bounds.
/// Threads: any may read while they hold a shared lock of mutex(); an editor (TileEditor) holds it
/// exclusively. A tile that is never edited needs no lock. Memory: that of the placed tile, 32 B per culling
/// node, and some bytes for each split vertex of triangles across the data's edge that lies beyond it.
class RoamTile
{
public:
    /// Measures the bounds of the vertices (ErrorTree), or finds them among the kept results: the same either
    /// way. Those of a tile with dense parts are not kept. `kept` null: measures.
    explicit RoamTile(PlacedTile placedTile, const foundation::KeptResults* kept = nullptr);

    /// The bounds of the bintree vertex at a point of the grid.
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

    /// Prefetches the memory that bound(v) will read.
    void prefetch(GridPoint v) const
    {
        if (tile.grid().isInData(v.column, v.row)) tile.samples().prefetch(v.column, v.row);
    }

    /// Rounds an error or a radius up to the least value that can be stored at a vertex; setBound() stores
    /// such values.
    float roundedUpError(GridPoint v, double errorM) const;
    float roundedUpRadius(GridPoint v, double radiusM) const;
    void setBound(GridPoint v, float errorM, float radiusM);

    /// All values that are stored at a point of the grid; restore() puts them back.
    struct Memo
    {
        TileSamples::Kept kept;
        float errorBeyondM = 0.0f, radiusBeyondM = 0.0f;
    };
    Memo memo(GridPoint v) const;
    void restore(GridPoint v, const Memo& memo);

    /// Widens the culling bounds to hold the present position of a point.
    void include(GridPoint v);

    /// Vertices whose errors are bounds that may be larger than the exact ones (BoundsUpdate).
    std::vector<GridPoint> looseVertices() const;
    void setLoose(GridPoint v, bool loose);

    /// Vertices beyond the data that have an error.
    std::vector<GridPoint> verticesBeyond() const;

    /// The number of edits so far, and the changes since an earlier one, for meshes that follow. None: it is
    /// too long ago.
    std::uint64_t revision() const { return _revision; }
    std::optional<std::vector<const TileChange*>> changesSince(std::uint64_t revision) const;
    void note(TileChange change);

    /// The mark of everything that the samples and their bounds follow from. Absent: the tile was made
    /// without kept results, has dense parts, or an editor has changed it.
    std::optional<foundation::ContentMark> mark() const { return _revision == 0 ? _mark : std::nullopt; }

    /// Adds what else the samples follow from, after they were changed without an editor.
    void addToMark(std::string_view bytes)
    {
        if (_mark) _mark->add(bytes);
    }

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

    static GridPoint placeOf(std::uint64_t key)
    {
        return {static_cast<int>(key & 0xffffffffu), static_cast<int>(key >> 32)};
    }

    SplitBound boundBeyond(GridPoint v) const;
    void admitSheets();
    void measureBounds();
    std::string boundBytes() const;
    bool takeBounds(std::string_view bytes);

    static constexpr std::size_t kMostNoted = 1 << 20; ///< vertices and rectangles

    std::unordered_map<std::uint64_t, Bound> _beyond; ///< only those that have an error
    std::unordered_set<std::uint64_t> _loose;
    std::deque<TileChange> _changes; ///< the last of them leads to _revision
    std::size_t _noted = 0;
    std::uint64_t _revision = 0;
    std::optional<foundation::ContentMark> _mark; ///< without what editors have changed
    mutable std::shared_mutex _mutex;
};

} // namespace osgTerrainROAM::core
