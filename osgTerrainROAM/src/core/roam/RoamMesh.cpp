// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <osgTerrainROAM/core/roam/ActiveInSight.h>
#include <osgTerrainROAM/core/roam/Refinement.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>
#include <osgTerrainROAM/core/roam/TriangleCeiling.h>
#include <osgTerrainROAM/core/roam/WalkDriver.h>

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kColdGuess = 64.0; ///< times the target: where the search for a ceiling's tolerance begins
constexpr int kMostAttempts = 4;    ///< to follow it from frame to frame instead …
constexpr double kNear = 0.2;       ///< … while the mesh is not farther from it than this share
constexpr auto kUnlimited = std::numeric_limits<std::uint32_t>::max();

} // namespace

RoamMesh::RoamMesh(SplitBounds bounds, Driver driver, LeafPlacement placement)
    : _driver(driver),
      _tree(std::move(bounds), placement),
      _wheel(_tree.tile()),
      _revision(_tree.tile().revision())
{
    if (patchExponent() == 0) return;
    _tree.noteGone();
    _patches.emplace(_tree);
}

void RoamMesh::setDriver(Driver driver)
{
    if (driver != _driver)
    {
        _wheel.forget();
        _queues.forget();
    }
    _driver = driver;
}

void RoamMesh::setSight(const viewlod::Sight& sight)
{
    _wheel.setSight(sight);
    _sight = sight;
}

/// Runs the walk or the wheel once. Returns false when a limit has stopped it.
bool RoamMesh::run(const viewlod::ViewState& view, double tolerancePx, std::uint32_t maxLeaves,
                   viewlod::Slice& slice, RefineResult& result)
{
    result.tolerancePx = tolerancePx;
    if (_driver == Driver::wheel) return _wheel.refine(_tree, view, tolerancePx, maxLeaves, slice, result);
    const ActiveInSight active(view, tolerancePx, _sight);
    return WalkDriver(_tree, active, maxLeaves, slice, result).refine();
}

/// Runs the walk or the wheel at the lowest tolerance that the ceiling allows. A mesh that was at the ceiling
/// starts with its last tolerance: while the leaves stay in a band below the ceiling, nothing else is
/// necessary; a small change of the tolerance brings them back into it. Otherwise a sweep over the bintree
/// finds the tolerance. Returns false when the slice has ended before.
bool RoamMesh::runWithinCeiling(const viewlod::ViewState& view, const viewlod::Budget& budget,
                                viewlod::Slice& slice, RefineResult& result)
{
    const std::uint32_t most = budget.maxTriangles, unused = std::max(most / 100, 4u);
    const double aim = most - 0.5 * unused, targetPx = budget.errorTolerancePx;
    double tolerancePx = _ceilingBound ? std::max(_lastTolerancePx, targetPx) : targetPx;
    for (int attempt = 1;; ++attempt)
    {
        const bool ran = run(view, tolerancePx, most, slice, result);
        const bool finished = ran && _tree.leafCount() <= most; // the ceiling may have come down
        if (finished && (tolerancePx <= targetPx || _tree.leafCount() + unused >= most)) return true;
        if (slice.isSpent()) return false;
        if (attempt > kMostAttempts) return finished;
        const double wanted = ran ? _tree.leafCount() : most + 2.0 * _wheel.waiting();
        const bool isNear = attempt < kMostAttempts && std::abs(wanted - aim) < kNear * aim;
        if (!isNear) attempt = kMostAttempts;
        // The number of leaves falls about as the tolerance rises.
        tolerancePx =
            isNear ? std::max(tolerancePx * wanted / aim, targetPx)
                   : toleranceWithinCeiling(_tree.bounds(), view, budget,
                                            _ceilingBound ? tolerancePx : kColdGuess * targetPx, _sight);
    }
}

RefineResult RoamMesh::refine(const viewlod::ViewState& view, const viewlod::Budget& budget)
{
    _tree.clearChanges();
    followTile();
    RefineResult result;
    if (!_isMorphing)
    {
        _tree.stopDisplacing();
        result = adapt(view, budget);
    }
    else
        result = adaptAndMorph(view, budget);
    _eye = view.eyeWorld;
    _nearM = view.nearM;
    // The coarsest mesh that morphing mixes has less than twice the error of the mixture.
    _errorPerM = (_isMorphing ? 2.0 : 1.0) * result.errorBoundPx / view.guaranteedPixelsPerTangent();
    return result;
}

RefineResult RoamMesh::adaptAndMorph(const viewlod::ViewState& view, const viewlod::Budget& budget)
{
    viewlod::Budget finer = budget;
    finer.errorTolerancePx *= Morph::kRefineShare;
    RefineResult result = adapt(view, finer);
    _morph.update(_tree, view, result.tolerancePx);
    result.tolerancePx /= Morph::kRefineShare;
    result.errorBoundPx /= Morph::kRefineShare;
    return result;
}

/// Adapts the mesh to an eye, without morphing.
RefineResult RoamMesh::adapt(const viewlod::ViewState& view, const viewlod::Budget& ofTriangles)
{
    RefineResult result;
    viewlod::Budget budget = ofTriangles;
    budget.maxTriangles = std::max(budget.maxTriangles >> patchExponent(), 2u); // the roots
    viewlod::Slice slice(budget);
    if (_driver == Driver::queue)
    {
        result.sliceBound = !_queues.refine(_tree, view, _sight, budget, slice, result);
    }
    else
    {
        result.sliceBound = !runWithinCeiling(view, budget, slice, result);
    }
    result.errorBoundPx = result.tolerancePx;
    if (_driver == Driver::wheel)
        result.errorBoundPx = _wheel.errorBoundPx(view, result.tolerancePx);
    else if (result.sliceBound)
        result.errorBoundPx = std::numeric_limits<double>::infinity();
    _ceilingBound = result.tolerancePx > budget.errorTolerancePx;
    result.ceilingBound = _ceilingBound && !result.sliceBound;
    _lastTolerancePx = result.tolerancePx;
    finish(result);
    return result;
}

/// Ends a refinement: follows with the patches, counts the leaves.
void RoamMesh::finish(RefineResult& result)
{
    if (_patches)
    {
        _patches->follow(_tree);
        rewritePatches();
    }
    result.leaves = _tree.leafCount() << patchExponent();
    result.triangles = _tree.leaves().leafCount() << patchExponent();
}

RefineResult RoamMesh::refine(double errorM)
{
    _tree.clearChanges();
    followTile();
    _tree.stopDisplacing();
    _wheel.forget();
    _queues.forget();
    _eye.reset();
    RefineResult result;
    viewlod::Slice unlimited({});
    const ActiveForError active{errorM};
    WalkDriver(_tree, active, kUnlimited, unlimited, result).refine();
    finish(result);
    return result;
}

} // namespace osgTerrainROAM::core
