// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// How made-up points lie in the plan: the distributions of the paper's table.
enum class PointDistribution
{
    uniform,
    normal,
    laplace,
    clustered, ///< normal around each of 20 places
};

/// Calls visit(point) for as many points of a distribution; few may lie at the place of another.
void streamMadeUpPoints(PointDistribution distribution, std::size_t count,
                        const std::function<void(const SurfacePoint&)>& visit, std::uint64_t seed = 1);

/// Returns points of a distribution on the whole lattice, no two at one place, with heights of rolling hills.
/// Source: *Multi-Triangulation as applied to very large terrains visualization* (Graphicon 2005), table 1,
/// which names the distributions and not their widths; here 1/8 of the extent, 1/60 for clusters. The same on
/// every machine.
std::vector<SurfacePoint> madeUpPoints(PointDistribution distribution, std::size_t count,
                                       std::uint64_t seed = 1);

} // namespace osgMultiTriangulation::core
