// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include <osgMultiTriangulation/core/split/BorderFit.h>

#include "BorderTrial.h"

namespace osgMultiTriangulation::core
{

BorderTrial::BorderTrial(const PointScan& scan, std::uint64_t points, SplitAt where, const BorderModel& model)
    : _points(static_cast<double>(points)),
      _partition(partitionPoints(scan, _points / balancedTreeCount(_points, model), where))
{
}

BorderModel BorderTrial::fitted(std::uint64_t borderPoints) const
{
    BorderModel model;
    const double rectangles = _partition.rectangles;
    if (hasBorders() && borderPoints > 0)
        model.c = static_cast<double>(borderPoints) / rectangles / std::pow(_points / rectangles, model.a);
    return model;
}

namespace
{

/// Counts the points of triangles whose corners lie in several rectangles.
std::uint64_t borderPointsOf(const SurfaceMesh& mesh, const BorderTrial& trial)
{
    std::vector<std::uint32_t> partOf;
    partOf.reserve(mesh.points.size());
    for (const SurfacePoint& point : mesh.points)
        partOf.push_back(trial.partAt(point));
    std::vector<bool> isOnBorder(mesh.points.size(), false);
    for (const Triangle& t : mesh.triangles)
        if (partOf[t[0]] != partOf[t[1]] || partOf[t[0]] != partOf[t[2]])
            for (const std::uint32_t corner : t)
                isOnBorder[corner] = true;
    return static_cast<std::uint64_t>(std::ranges::count(isOnBorder, true));
}

} // namespace

BorderModel fitBorder(const SurfaceMesh& mesh, SplitAt where)
{
    BorderModel model;
    for (int round = 0; round < BorderTrial::kRounds; ++round)
    {
        const BorderTrial trial([&mesh](const auto& visit) { visit(std::span(mesh.points)); },
                                mesh.points.size(), where, model);
        if (!trial.hasBorders()) return model;
        model = trial.fitted(borderPointsOf(mesh, trial));
    }
    return model;
}

} // namespace osgMultiTriangulation::core
