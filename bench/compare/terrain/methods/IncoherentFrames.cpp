// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/IncoherentFrames.h"

#include <cassert>
#include <limits>

#include <viewlod/Slice.h>

#include <osgTerrainROAM/core/roam/ActiveInSight.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>
#include <osgTerrainROAM/core/roam/ScratchRefinement.h>
#include <osgTerrainROAM/core/roam/WalkDriver.h>

#include "compare/terrain/drivers/Measured.h"
#include "measurement/Percentile.h"
#include "measurement/flights/BenchmarkFlight.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;

constexpr int kMeasuredFrames = 40;
constexpr double kMarginRad = 0.0872665; // 5 degrees
constexpr auto kAnyNumber = std::numeric_limits<std::uint32_t>::max();

struct IncoherentPath
{
    std::string name;
    measurement::BenchmarkFlight flight;
    bool inSight = false;
    int stride = 1; ///< frames of the flight from one to the next
};

std::vector<IncoherentPath> incoherentPaths()
{
    using measurement::Path;
    std::vector<IncoherentPath> paths{
        {"jump", {.path = Path::jump}},
        {"half the tile", {.path = Path::jump, .jumpM = std::numeric_limits<double>::infinity()}},
        {"about-face", {.path = Path::uturn}}};
    for (std::size_t i = 0, around = paths.size(); i < around; ++i)
        paths.push_back({paths[i].name + ", in sight", paths[i].flight, true});
    constexpr int kTurn = measurement::BenchmarkFlight::kFrames / kMeasuredFrames;
    paths.push_back({"look-around, in sight", {.path = Path::turn}, true, kTurn});
    return paths;
}

/// One way along one path: whatever it keeps from frame to frame.
class ReworkedMesh
{
public:
    ReworkedMesh(Rework way, const SplitBounds& bounds)
        : _way(way), _bounds(bounds), _tree(bounds), _mesh(bounds)
    {
    }

    /// Returns the number of triangles split and merged.
    std::uint32_t adapt(const viewlod::ViewState& view, double tolerancePx, const viewlod::Sight& sight)
    {
        if (_way == Rework::bareList)
        {
            refineFromScratch(_bounds, view, tolerancePx, _leaves, sight);
            return static_cast<std::uint32_t>(_leaves.size());
        }
        if (_way != Rework::wheel) return reworkTree(_way, _tree, view, tolerancePx, sight);
        _mesh.setSight(sight);
        const RefineResult result = _mesh.refine(view, {.errorTolerancePx = tolerancePx});
        return result.splits + result.merges;
    }

private:
    Rework _way;
    const SplitBounds& _bounds;
    DiamondTree _tree;
    RoamMesh _mesh;
    std::vector<GridTriangle> _leaves;
};

ReworkFigures measureRework(Rework way, const IncoherentPath& path, const SplitBounds& bounds,
                            double tolerancePx)
{
    ReworkedMesh mesh(way, bounds);
    std::vector<double> us;
    double changed = 0.0;
    for (int frame = 0; frame <= kMeasuredFrames; ++frame)
    {
        const viewlod::ViewState view = path.flight.view(bounds.tile().tile, path.stride * frame);
        viewlod::Sight sight;
        if (path.inSight) sight.add(view, kMarginRad);
        std::uint32_t triangles = 0;
        const double frameUs = microsecondsOf([&] { triangles = mesh.adapt(view, tolerancePx, sight); });
        if (frame == 0) continue; // builds the mesh
        us.push_back(frameUs);
        changed += triangles;
    }
    return {path.name,
            reworkName(way),
            path.inSight,
            measurement::percentile(us, 0.5),
            measurement::percentile(us, 1.0),
            changed / kMeasuredFrames};
}

} // namespace

const char* reworkName(Rework way)
{
    constexpr const char* kNames[] = {"wheel", "enhMerge", "one by one", "restart", "bare list"};
    return kNames[static_cast<int>(way)];
}

std::uint32_t reworkTree(Rework way, DiamondTree& tree, const viewlod::ViewState& view, double tolerancePx,
                         const viewlod::Sight& sight)
{
    assert(way != Rework::wheel && way != Rework::bareList);
    tree.clearChanges();
    RefineResult result;
    const TriangleId root = DiamondTree::kRoots[0];
    if (way == Rework::restart && !tree.isLeaf(root)) result.merges += tree.enhMerge(tree.splitVertex(root));
    viewlod::Slice unlimited({});
    const ActiveInSight active(view, tolerancePx, sight);
    const Removal removal = way == Rework::oneByOne ? Removal::oneByOne : Removal::atOnce;
    WalkDriver(tree, active, kAnyNumber, unlimited, result, removal).refine();
    return result.splits + result.merges;
}

std::vector<ReworkFigures> measureReworks(const std::shared_ptr<const RoamTile>& tile, double tolerancePx)
{
    const SplitBounds bounds(tile);
    std::vector<ReworkFigures> all;
    for (const IncoherentPath& path : incoherentPaths())
        for (const Rework way : kReworks)
            all.push_back(measureRework(way, path, bounds, tolerancePx));
    return all;
}

} // namespace terraintool
