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

/// Grid points whose heights may have changed: those of a rectangle whose coordinates are multiples of
/// `step`.
struct ChangedPlaces
{
    GridRect rect;
    int step = 1;
};

/// Brings the errors and radii of a tile up to date after heights have changed, level by level from the
/// finest. It visits the vertices whose diamonds touch changed samples, and the ancestors of changed bounds.
/// A diamond of at most kScanFactor times as many samples as have changed is measured again: its error is
/// exact. A larger diamond gets a bound that costs no scan: the smaller of (old error + largest movement of a
/// corner) and (largest error of its children + distance of its vertex from its base edge). Such vertices are
/// noted as loose; tighten() measures them.
/// Invariant: bounds are nested, and no error is less than the exact one. Cost: some 20 visits of each
/// changed sample and its surroundings, whatever the size of the tile.
/// Source: Lindstrom & Pascucci, *Visualization of Large Terrains Made Easy*, 2001 (nested errors and radii);
/// the update is ours.
class BoundsUpdate
{
public:
    static constexpr std::size_t kScanFactor = 16;

    /// A vertex whose bounds have changed, and all that was kept there before.
    struct Change
    {
        GridPoint vertex;
        RoamTile::Memo before;
    };

    explicit BoundsUpdate(RoamTile& tile) : _tile(tile) {}

    /// Follows heights that have changed by up to `movedM`; points beyond the edge of the data follow the
    /// edge. Returns the vertices whose bounds have changed.
    std::vector<Change> follow(std::span<const ChangedPlaces> changed, double movedM);

    /// Extends errors and radii over the new samples of the tile's sheets. No vertex of the raster has moved.
    /// `added`: the sheets' rectangles.
    void admit(std::span<const ChangedPlaces> added);

    /// Measures loose vertices, the finest first, until `mostSamples` samples have been read; one vertex at
    /// least. Returns the same as follow().
    std::vector<Change> tighten(std::size_t mostSamples);

private:
    /// A vertex to visit. Its own error must be found where the kept one may be too large.
    struct Wanted
    {
        GridPoint vertex;
        bool needsOwnError;
    };

    std::vector<Change> run();
    void visitLevel(int half, bool isCentre);
    void collect(const ChangedPlaces& changed, int half, bool isCentre, std::vector<Wanted>& wanted) const;
    void collectIn(const GridRect& rect, int half, bool isCentre, std::vector<Wanted>& wanted) const;
    std::vector<double> measuredAtOnce(const std::vector<Wanted>& wanted) const;
    void visit(const Wanted& wanted, double measuredM);
    void propagate(const SplitDiamond& diamond, const SplitBound& before, const SplitBound& after);
    bool isSmall(const SplitDiamond& diamond) const;
    double ownErrorM(const SplitDiamond& diamond, double beforeM, double measuredM);
    double measuredM(const SplitDiamond& diamond) const;
    double boundM(const SplitDiamond& diamond, double beforeM) const;
    double changedErrorM(const GridTriangle& triangle) const;
    bool hasMoved(GridPoint corner) const;
    std::size_t samplesIn(const SplitDiamond& diamond) const;

    RoamTile& _tile;
    std::span<const ChangedPlaces> _changed;
    double _movedM = 0.0;
    const SheetErrors* _admitted = nullptr; ///< while samples of sheets are new
    std::size_t _mostSamples = 0;           ///< larger diamonds are not measured
    std::array<std::vector<Wanted>, TileGrid::kMostLevels> _wanted;
    std::vector<Change> _changes;
};

} // namespace osgTerrainROAM::core
