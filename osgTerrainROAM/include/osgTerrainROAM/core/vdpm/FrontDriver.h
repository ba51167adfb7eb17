// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include <viewlod/Slice.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/DeferralWheel.h>
#include <osgTerrainROAM/core/roam/RefineResult.h>
#include <osgTerrainROAM/core/vdpm/ActiveFront.h>
#include <osgTerrainROAM/core/vdpm/BoundedForest.h>
#include <osgTerrainROAM/core/vdpm/SplitCriterion.h>

namespace osgTerrainROAM::core
{

/// Refines a front for eyes, from one to the next. A split is *wanted* when the criterion says so; it is done
/// when it is wanted or a wanted one depends on it. So the mesh depends on the eye alone. It watches the
/// splits whose finder is wanted. Their decisions hold while the eye has not travelled far enough to change
/// them (DeferralWheel); with a criterion that looks at the frustum or at orientation, all of them are
/// checked in each frame.
/// Invariant: keepsDependencies(). Cost: the changes and the due checks; nothing while nothing changes.
/// Memory: 6 B for each split of the forest, 4 B for each watch.
/// Source: Hoppe, *View-dependent refinement of progressive meshes*, 1997, sections 4 and 5 (incremental
/// refinement, amortisation).
/// Differs: splits are found along nested bounds, dependencies are counted, and checks are deferred.
class FrontDriver
{
public:
    /// `forest` must live as long.
    explicit FrontDriver(const BoundedForest& forest);

    /// Splits and collapses until the mesh is that of the criterion. Returns false when it stopped before: a
    /// split with those that it needs would have exceeded `maxFaces`, or the slice is spent. The mesh is
    /// valid then, too; the next call goes on.
    bool refine(const SplitCriterion& criterion, std::uint32_t maxFaces, viewlod::Slice& slice,
                RefineResult& result);

    /// From the next refinement on, vertices move to their places, and back before they go, in so many
    /// refinements; 0: they jump. A split begins only when all that it depends on have ended, so that what
    /// moves at the same time has no face in common: then the error of each is known. Where a bound exceeds
    /// `mostPx` before, it is done at once.
    void setMorph(std::uint8_t frames, double mostPx);

    /// Moves vertices by a frame. Call it once after each refinement.
    void moveVertices(const SplitCriterion& criterion, RefineResult& result);

    /// How far a vertex has moved from v1 of its split to its own place, 0…1. Vertices of M0: 1.
    float weightOf(std::uint32_t vertex) const
    {
        const std::uint32_t split = _forest.forest.makerOfVertex(vertex);
        return split == kNone || _phases[split] == kInPlace
                   ? 1.0f
                   : static_cast<float>(_phases[split]) / static_cast<float>(_morphFrames);
    }

    /// The number of splits so far that were done at once although vertices ought to move.
    std::uint64_t jumps() const { return _jumps; }

    /// Has all splits checked at the next refinement.
    void forget() { _knowsFront = false; }

    /// The bound of the error of every sample: the criterion's tolerance, or more when work is left; infinite
    /// while due splits have not been checked. The criterion is that of the last refinement.
    double errorBoundPx(const SplitCriterion& criterion) const;

    /// The number of wanted splits that are not done.
    std::size_t waiting() const;

    const ActiveFront& front() const { return _front; }
    void clearChanges() { _front.clearChanges(); }
    void trimChanges() { _front.trimChanges(); }
    bool isWanted(std::uint32_t split) const { return _isWanted[split] != 0; }

    /// Whether each split that is done has its dependencies done, counts are right, and, when nothing waits,
    /// each is wanted or needed.
    bool keepsDependencies() const;

    std::size_t memoryBytes() const;

private:
    struct Frame
    {
        const SplitCriterion& criterion;
        std::uint32_t maxFaces;
        viewlod::Slice& slice;
        RefineResult& result;
    };

    void restart();
    void checkDue(Frame& frame);
    void checkFound(Frame& frame);
    void check(Frame& frame, std::uint32_t split);
    void unwant(std::uint32_t split);
    void coarsen(Frame& frame);
    bool refineWanted(Frame& frame);
    bool force(Frame& frame, std::uint32_t split);
    void gatherNeeded(std::uint32_t split);
    bool isInPlace(std::uint32_t split) const { return _front.isDone(split) && _phases[split] == kInPlace; }
    void doSplit(Frame& frame, std::uint32_t split);
    bool begin(Frame& frame, std::uint32_t split);
    void remove(std::uint32_t split);
    void stopMoving();

    const BoundedForest& _forest;
    ActiveFront _front;
    DeferralWheel _wheel;
    std::vector<DeferralWheel::Mark> _marks; ///< by split; 0: not watched
    static constexpr std::uint8_t kInPlace = 255;
    std::uint8_t _morphFrames = 0;
    double _mostPx = 0.0;
    std::uint64_t _jumps = 0;
    std::vector<std::uint8_t> _phases; ///< by split: frames that its vertex has moved, or kInPlace
    std::vector<std::uint8_t> _isHeld; ///< by split: one that waits needs it in this frame
    std::vector<std::uint32_t> _moving, _held;
    std::vector<std::uint8_t> _isWanted;              ///< by split
    std::vector<std::uint32_t> _dependants;           ///< by split: done splits that depend on it
    std::vector<std::uint32_t> _toSplit, _toCollapse; ///< splits to look at; decisions may have changed since
    std::vector<std::uint32_t> _found; ///< splits to check for the first time: their finder has become wanted
    std::vector<std::uint32_t> _halfDone;      ///< splits that were done for one that waits still
    std::vector<std::uint32_t> _needed, _path; ///< memory of operations
    bool _knowsFront = false;
    glm::dvec3 _eye{0.0};
    double _scale = 0.0, _nearM = 0.0;
};

} // namespace osgTerrainROAM::core
