// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include <glm/glm.hpp>

#include <viewlod/Slice.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/DeferralWheel.h>
#include <osgTerrainROAM/core/roam/DiamondTree.h>
#include <osgTerrainROAM/core/roam/RefineResult.h>
#include <osgTerrainROAM/core/roam/Refinement.h>

namespace osgTerrainROAM::core
{

/// Takes a tree from eye to eye and looks only at vertices that may have changed sides.
/// Watched are the active vertices, and the vertices that could come next: those whose parents both are active. When one
/// comes, what may follow it is watched; when one goes, its whole subtree goes (enhMerge).
/// A frame that is stopped by its limits leaves the rest for the next one, which begins with it.
/// Invariant: each vertex that could come is watched from one of its parents' quadrants, or waits.
/// Cost: what changes, and what is due; nothing when eye and scale stand still. Memory: 5 B per vertex and 4 B per watch.
/// Source: spec 1 D, "Deferral".
class WheelDriver
{
public:
    explicit WheelDriver(const RoamTile& tile) : _wheel(tile.tile.field().spacingEastM * kTicksPerCell) {}

    /// The tree has changed by other hands: everything is looked at again.
    void forget() { _knowsTree = false; }

    /// A vertex has other bounds now, or lies elsewhere: it is looked at with the next refinement.
    void lookAgain(GridPoint p) { _again.push_back(p); }

    /// Splits and merges until exactly the active vertices are split. False when it stopped before: the next split would
    /// have exceeded `maxLeaves`, or the slice is spent. The mesh is valid then, too.
    bool refine(DiamondTree& tree, const viewlod::ViewState& view, double tolerancePx,
                std::uint32_t maxLeaves, viewlod::Slice& slice, RefineResult& result);

    /// No sample is off by more after a refinement for `view` and `tolerancePx`: that, or more when it was stopped;
    /// infinite while vertices that are due have not been looked at.
    double errorBoundPx(const viewlod::ViewState& view, double tolerancePx) const;

    /// Triangles that would have been split, had there been room or time.
    std::size_t waiting() const { return _coming.size(); }

    std::size_t memoryBytes() const;

private:
    static constexpr double kTicksPerCell = 1.0 / 256.0;
    static constexpr unsigned kItself = 4; ///< a watch on the vertex; less: on what would split that quadrant
    static constexpr DeferralWheel::Mark kNotWatched = 0, kWaits = 255;

    /// What all that waits to be split comes up to.
    struct Backlog
    {
        double errorPerM = 0.0; ///< the largest e / distance when it was found …
        double nearestM = std::numeric_limits<double>::infinity(); ///< … and the least distance
        double sinceM = 0.0; ///< the eye's way when the first of it was found
    };

    /// One refinement.
    struct Frame
    {
        DiamondTree& tree;
        const ActiveForEye active;
        double nearM;
        std::uint32_t maxLeaves;
        viewlod::Slice& slice;
        RefineResult& result;
    };

    void startOver(Frame& frame);
    void lookAgain(Frame& frame);
    void lookAtDue(Frame& frame);
    void lookAtBatch(Frame& frame, const DeferralWheel::Batch& batch);
    static GridPoint watchedPlace(const DiamondTree& tree, VertexSlot v, unsigned kind);
    void look(Frame& frame, VertexSlot v, unsigned kind);
    void lookAt(Frame& frame, std::uint32_t watch, DeferralWheel::Mark& mark, GridPoint place);
    void found(Frame& frame, std::uint32_t watch, double errorM, double belowM);
    void follow(Frame& frame, VertexSlot v);
    void followNew(Frame& frame);
    bool change(Frame& frame, bool staleLeaving, std::size_t staleComing);
    bool letGo(Frame& frame, bool areStale);
    void takeOut(Frame& frame, VertexSlot v, bool isStale);
    bool letCome(Frame& frame, std::size_t stale);

    DeferralWheel _wheel;
    std::vector<std::array<DeferralWheel::Mark, 5>> _marks; ///< by vertex and kind
    std::array<std::vector<VertexSlot>, TileGrid::kMostLevels>
        _leaving; ///< vertices that are active no longer, by level
    std::size_t _leavingCount = 0;
    std::vector<TriangleId> _coming; ///< triangles whose split vertex has become active
    std::vector<GridPoint> _again;   ///< that lookAgain() was told of
    Backlog _backlog;                ///< of _coming since it was empty last
    std::size_t _followed = 0;       ///< of the tree's new vertices in this frame
    bool _knowsTree = false;
    glm::dvec3 _eye{0.0};
    double _scale = 0.0, _nearM = 0.0;
    double _wayM = 0.0; ///< that the eye has come
};

} // namespace osgTerrainROAM::core
