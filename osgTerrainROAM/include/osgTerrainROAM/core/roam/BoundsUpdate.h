// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <osgTerrainROAM/core/roam/RoamTile.h>
#include <osgTerrainROAM/core/roam/SplitDiamond.h>

namespace osgTerrainROAM::core
{

class SheetErrors;

/// Places whose heights may have changed: those of a rectangle that are multiples of `step`.
struct ChangedPlaces
{
    GridRect rect;
    int step = 1;
};

/// Brings the errors and radii of a tile up to date after heights have changed, level by level from the finest.
/// Looked at are the vertices whose diamonds touch what has changed, and those above bounds that have. The errors of
/// diamonds that hold up to kScanFactor times as many samples as have changed are measured anew, and exact. For larger
/// ones a bound is used that costs nothing of their size: what it was plus how far a corner has moved, or the children's
/// errors plus the vertex's own distance from its base, whichever is less. Those are noted as loose; tighten() measures
/// them.
/// Invariant: nested, and no error is less than the exact one. Cost: some 20 visits of each changed sample and its
/// surroundings, whatever the size of the tile.
/// Source: spec 1 D, "The wheel in formulas" (e_v, r_v).
class BoundsUpdate
{
public:
    static constexpr std::size_t kScanFactor = 16;

    /// A vertex whose bounds are others now, and all that was kept there.
    struct Change
    {
        GridPoint vertex;
        RoamTile::Memo before;
    };

    explicit BoundsUpdate(RoamTile& tile) : _tile(tile) {}

    /// `changed`: heights that have changed by up to `movedM`; places beyond the edge follow those at it. Returns the
    /// vertices whose bounds have changed.
    std::vector<Change> follow(std::span<const ChangedPlaces> changed, double movedM);

    /// The samples of the tile's sheets are new: no corner has moved, but errors and radii have to reach over them.
    /// `added`: their rectangles.
    void admit(std::span<const ChangedPlaces> added);

    /// Measures loose vertices, the finest first, as many as have `mostSamples` samples, but one at least. Returns as
    /// follow().
    std::vector<Change> tighten(std::size_t mostSamples);

private:
    /// A vertex to visit. Its own error has to be known where what it has may be too much.
    struct Wanted
    {
        GridPoint vertex;
        bool needsOwnError;
    };

    std::vector<Change> run();
    void visitLevel(int half, bool isCentre);
    void collect(const ChangedPlaces& changed, int half, bool isCentre, std::vector<Wanted>& wanted) const;
    void collectIn(const GridRect& rect, int half, bool isCentre, std::vector<Wanted>& wanted) const;
    void visit(const Wanted& wanted);
    void propagate(const SplitDiamond& diamond, const SplitBound& before, const SplitBound& after);
    double ownErrorM(const SplitDiamond& diamond, double beforeM);
    double measuredM(const SplitDiamond& diamond) const;
    double boundM(const SplitDiamond& diamond, double beforeM) const;
    double changedErrorM(const GridTriangle& triangle) const;
    bool hasMoved(GridPoint corner) const;
    std::size_t samplesIn(const SplitDiamond& diamond) const;

    RoamTile& _tile;
    std::span<const ChangedPlaces> _changed;
    double _movedM = 0.0;
    const SheetErrors* _admitted = nullptr; ///< while samples of sheets are new
    std::size_t _mostSamples = 0;           ///< of a diamond that is measured
    std::array<std::vector<Wanted>, TileGrid::kMostLevels> _wanted;
    std::vector<Change> _changes;
};

} // namespace osgTerrainROAM::core
