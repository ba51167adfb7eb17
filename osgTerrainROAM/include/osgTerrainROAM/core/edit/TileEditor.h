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

/// A new height of a grid point. Units: metres in the samples' datum.
struct HeightChange
{
    GridPoint place;
    float heightM;
};

/// The report of one edit.
struct EditReport
{
    std::size_t samplesChanged = 0; ///< new samples included
    std::size_t boundsChanged = 0;  ///< vertices whose error or radius has changed
    double largestChangeM = 0.0;
};

/// Changes the heights of a tile while others draw it: samples, errors, radii and culling bounds. Notes for
/// the meshes what has changed. Every step can be undone.
/// Threads: one at a time; the editor holds RoamTile::mutex alone while it writes. Memory: about 60 B for
/// each changed sample, until forgetUndo().
class TileEditor
{
public:
    static constexpr double kHighestM = 20000.0; ///< heights beyond ± this value are refused

    explicit TileEditor(std::shared_ptr<RoamTile> tile) : _tile(std::move(tile)) {}

    const RoamTile& tile() const { return *_tile; }

    /// What happens to the surface between the changed samples.
    enum class Between
    {
        follows, ///< it follows them, as if the raster had been so: only existing samples change
        stays,   ///< it stays as it is up to the next grid point: samples are added where there are none
    };

    /// Applies all changes or, in case of an error, none. Of two changes of one point the later counts.
    /// Errors: a point beyond the data, or without a sample where `between` needs one; a height that is no
    /// number or out of bounds.
    foundation::Result<EditReport> apply(std::span<const HeightChange> changes, Between between);

    /// Undoes the last step: every height and bound is what it was before. Returns false when there is no
    /// step.
    bool undo();
    std::size_t undoSteps() const { return _steps.size(); }
    void forgetUndo() { _steps.clear(); }

    /// Measures errors that edits have only bounded (BoundsUpdate): `mostSamples` samples at most, but one
    /// vertex at least. Returns true when all errors are exact.
    bool tighten(std::size_t mostSamples = 1 << 16);

private:
    /// What undoing one edit needs.
    struct Step
    {
        std::vector<std::pair<GridPoint, RoamTile::Memo>> samples;
        std::vector<BoundsUpdate::Change> bounds;
        std::vector<ChangedPlaces> changed;
        double movedM = 0.0;
        bool boundsAreStale = false; ///< bounds have been tightened since
    };

    void note(const Step& step, std::span<const BoundsUpdate::Change> bounds);

    foundation::Outcome check(std::span<const HeightChange> changes, Between between) const;
    void write(std::span<const HeightChange> changes, Between between, Step& step, EditReport& report);
    void surround(std::span<const HeightChange> changes, Step& step);

    std::shared_ptr<RoamTile> _tile;
    std::vector<Step> _steps;
};

} // namespace osgTerrainROAM::core
