// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/roam/BoundsUpdate.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// A new height for a place of the grid. Units: metres, as the tile's samples are counted.
struct HeightChange
{
    GridPoint place;
    float heightM;
};

/// What an edit did.
struct EditReport
{
    std::size_t samplesChanged = 0; ///< those put between others included
    std::size_t boundsChanged = 0;  ///< vertices with another error or radius
    double largestChangeM = 0.0;
};

/// Changes the heights of a tile while others show it: samples, errors, radii and culling bounds, and notes what has changed
/// for the meshes. Every step can be taken back.
/// Threads: any one at a time; it waits for readers of the tile (RoamTile::mutex) and they for it. Memory: about 60 B for
/// each sample changed, until forgetUndo().
class TileEditor
{
public:
    static constexpr double kHighestM = 20000.0; ///< heights beyond are refused, above and below

    explicit TileEditor(std::shared_ptr<RoamTile> tile) : _tile(std::move(tile)) {}

    const RoamTile& tile() const { return *_tile; }

    /// What becomes of the surface between the samples that change.
    enum class Between
    {
        follows, ///< as if the raster had been so: only places that have samples are changed
        stays,   ///< it stays as it is up to the next place of the grid: samples are put where there are none
    };

    /// Changes heights; all or, in case of an error, nothing. A place that is given twice takes the last. Errors: a place
    /// beyond the data, or without a sample where `between` demands one; a height that is no number or out of bounds.
    foundation::Result<EditReport> apply(std::span<const HeightChange> changes, Between between);

    /// Takes the last step back: every height and bound is what it was before. False: there is none.
    bool undo();
    std::size_t undoSteps() const { return _steps.size(); }
    void forgetUndo() { _steps.clear(); }

    /// Measures errors that edits have only bounded: `mostSamples` samples at most, but one vertex at least. True when all
    /// are exact.
    bool tighten(std::size_t mostSamples = 1 << 16);

private:
    /// How to take an edit back.
    struct Step
    {
        std::vector<std::pair<GridPoint, RoamTile::Memo>> samples;
        std::vector<BoundsUpdate::Change> bounds;
        std::vector<ChangedPlaces> changed;
        double movedM = 0.0;
        bool boundsAreStale = false; ///< others have been tightened since
    };

    void note(const Step& step, std::span<const BoundsUpdate::Change> bounds);

    foundation::Outcome check(std::span<const HeightChange> changes, Between between) const;
    void write(std::span<const HeightChange> changes, Between between, Step& step, EditReport& report);
    void surround(std::span<const HeightChange> changes, Step& step);

    std::shared_ptr<RoamTile> _tile;
    std::vector<Step> _steps;
};

} // namespace osgTerrainROAM::core
