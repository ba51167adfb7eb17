// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include <glm/glm.hpp>

#include <viewlod/Sight.h>
#include <viewlod/Slice.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/ActiveInSight.h>
#include <osgTerrainROAM/core/roam/DeferralWheel.h>
#include <osgTerrainROAM/core/roam/DiamondTree.h>
#include <osgTerrainROAM/core/roam/RefineResult.h>

namespace osgTerrainROAM::core
{

/// Adapts a tree from eye to eye, and checks only vertices whose decision may have changed.
/// It watches the active vertices, and the candidates: vertices whose parents are both active. After a split
/// it watches the new candidates; an inactive vertex is removed with its whole subtree (enhMerge). A frame
/// that its limits stop leaves the rest of its work for the next frame, which begins with it.
/// Invariant: each candidate is watched from one of its parents' quadrants, or waits to be split.
/// Cost: the changes and the due watches; none while eye and scale stand still. Memory: 5 B per vertex and 4
/// B per watch.
/// Source: *Methods of continuous level of detail for terrain* (Graphicon 2002), section 5.2 (the loop over
/// splits and enhMerge). Differs: a deferral wheel decides which vertices are checked (DeferralWheel.h).
class WheelDriver
{
public:
    explicit WheelDriver(const RoamTile& tile) : _wheel(tile.tile.field().spacingEastM * kTicksPerCell) {}

    /// Forgets everything, because the tree was changed from outside: the next refinement checks all
    /// vertices.
    void forget() { _knowsTree = false; }

    /// Refines only what is in sight from the next refinement on. The distance that the eye travels says
    /// nothing about what it sees, so with a sight all that is active for the eye is checked in each frame in
    /// which eye or sight move.
    void setSight(const viewlod::Sight& sight)
    {
        if (sight == _sight) return;
        if (sight.isEverything() != _sight.isEverything()) forget();
        _sight = sight;
        _sightMoved = true;
    }

    /// Has a vertex, whose bounds or position have changed, checked again in the next refinement.
    void recheck(GridPoint p) { _rechecks.push_back(p); }

    /// Splits and merges until exactly the active vertices are split. Returns false when it stopped before:
    /// the next split would have exceeded `maxLeaves`, or the slice is spent. The mesh is valid then, too.
    bool refine(DiamondTree& tree, const viewlod::ViewState& view, double tolerancePx,
                std::uint32_t maxLeaves, viewlod::Slice& slice, RefineResult& result);

    /// The bound of the error of every sample after a refinement for `view` and `tolerancePx`: the tolerance,
    /// or more when it was stopped; infinite while due vertices have not been checked.
    double errorBoundPx(const viewlod::ViewState& view, double tolerancePx) const;

    /// Triangles that would have been split with more room or time.
    std::size_t waiting() const { return _splits.size(); }

    std::size_t memoryBytes() const;

private:
    static constexpr double kTicksPerCell = 1.0 / 256.0;
    static constexpr unsigned kItself =
        4; ///< a watch on the vertex; 0…3: on the candidate that would split that quadrant
    static constexpr DeferralWheel::Mark kNotWatched = 0, kWaits = 255;

    /// The bounds of all waiting splits.
    struct Backlog
    {
        double errorPerM = 0.0; ///< the largest e / distance when it was found …
        double nearestM = std::numeric_limits<double>::infinity(); ///< … and the least distance
        double sinceM = 0.0; ///< length of the eye's path when the first was found
    };

    /// One refinement.
    struct Frame
    {
        DiamondTree& tree;
        const ActiveInSight active;
        double nearM;
        std::uint32_t maxLeaves;
        viewlod::Slice& slice;
        RefineResult& result;
    };

    void restart(Frame& frame);
    void runRechecks(Frame& frame);
    void checkDue(Frame& frame);
    void checkBatch(Frame& frame, const DeferralWheel::Batch& batch);
    static GridPoint watchedPoint(const DiamondTree& tree, VertexSlot v, unsigned kind);
    void check(Frame& frame, VertexSlot v, unsigned kind);
    void checkWatched(Frame& frame, std::uint32_t watch, DeferralWheel::Mark& mark, GridPoint place);
    void schedule(Frame& frame, std::uint32_t watch, double errorM, double belowM);
    void watchAround(Frame& frame, VertexSlot v);
    void watchNew(Frame& frame);
    bool applyScheduled(Frame& frame, bool staleMerges, std::size_t staleSplits);
    bool mergeScheduled(Frame& frame, bool areStale);
    void mergeVertex(Frame& frame, VertexSlot v, bool isStale);
    bool splitScheduled(Frame& frame, std::size_t stale);

    DeferralWheel _wheel;
    std::vector<std::array<DeferralWheel::Mark, 5>> _marks;             ///< by vertex and kind
    std::array<std::vector<VertexSlot>, TileGrid::kMostLevels> _merges; ///< vertices to remove, by level
    std::size_t _mergeCount = 0;
    std::vector<TriangleId> _splits;  ///< triangles to split: their split vertex has become active
    std::vector<GridPoint> _rechecks; ///< points that recheck() was called for
    Backlog _backlog;                 ///< of _splits since it was last empty
    std::size_t _watched = 0;         ///< position in the tree's changes up to which vertices are watched
    viewlod::Sight _sight;
    bool _sightMoved = false; ///< since the last refinement
    bool _knowsTree = false;
    glm::dvec3 _eye{0.0};
    double _scale = 0.0, _nearM = 0.0;
    double _pathM = 0.0; ///< length of the eye's path
};

} // namespace osgTerrainROAM::core
