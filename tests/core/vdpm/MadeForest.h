// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include <osgMultiTriangulation/core/build/CollapseOrder.h>
#include <osgMultiTriangulation/core/surface/GridSurface.h>
#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/simplify/Simplify.h>
#include <osgTerrainROAM/core/vdpm/BuildForest.h>

#include "Random.h"

namespace testsupport
{

/// A mesh and its forest.
struct MadeForest
{
    std::vector<osgPMObjects::core::Triangle> triangles;
    osgTerrainROAM::core::VertexForest forest;
};

/// A grid of rolling ground, side × side points, simplified by exact error: a mesh with a border.
inline MadeForest groundForest(int side, std::uint64_t seed = 3)
{
    Random random(seed);
    std::vector<float> heights;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            heights.push_back(
                static_cast<float>(10.0 * std::sin(0.7 * column) * std::cos(0.5 * row) + random.unit()));
    const auto mesh = osgMultiTriangulation::core::gridSurface(side, side, heights);
    std::vector<osgTerrainROAM::core::EdgeCollapse> collapses;
    for (const auto& c : osgMultiTriangulation::core::collapseOrder(mesh))
        collapses.push_back({c.vertex, c.into});
    return {mesh.triangles, osgTerrainROAM::core::buildForest(
                                mesh.triangles, static_cast<std::uint32_t>(mesh.points.size()), collapses)};
}

/// A closed mesh, simplified by quadrics.
inline MadeForest closedForest(const osgPMObjects::core::Mesh& mesh)
{
    std::vector<osgTerrainROAM::core::EdgeCollapse> collapses;
    for (const auto& step : osgPMObjects::core::simplify(mesh).steps)
        collapses.push_back({step.from, step.to});
    auto triangles = osgPMObjects::core::positionTriangles(mesh);
    auto forest = osgTerrainROAM::core::buildForest(
        triangles, static_cast<std::uint32_t>(mesh.positions.size()), collapses);
    return {std::move(triangles), std::move(forest)};
}

} // namespace testsupport
