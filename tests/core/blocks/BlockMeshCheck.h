// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/TerrainMesh.h>

namespace testsupport
{

/// What the brute-force check says of a mesh as a whole.
inline testing::AssertionResult isSound(const osgTerrainROAM::core::TerrainMesh& mesh,
                                        const viewlod::ViewState& view, double tolerancePx)
{
    if (!mesh.isValid()) return testing::AssertionFailure() << "the mesh is not valid";
    const auto report = osgTerrainROAM::core::checkDrawnMesh(mesh.tile(), mesh.drawn(), &view);
    if (report.tJunctions + report.cracks > 0 || !(report.maxErrorPx <= tolerancePx))
        return testing::AssertionFailure()
               << report.tJunctions << " T-junctions, " << report.cracks << " cracks, " << report.maxErrorPx
               << " px where " << tolerancePx << " are allowed";
    return testing::AssertionSuccess() << report.maxErrorPx << " px";
}

/// The mesh as a set of triangles by places and positions, whatever slots they have.
using Pictured = std::multiset<std::vector<int>>;
inline Pictured pictured(const osgTerrainROAM::core::TerrainMesh& mesh)
{
    Pictured triangles;
    const osgTerrainROAM::core::DrawnMesh drawn = mesh.drawn();
    for (const osgTerrainROAM::core::LeafTriangle& t : drawn.triangles)
    {
        std::vector<int> numbers;
        for (const std::uint32_t v : t.vertices)
            numbers.insert(numbers.end(),
                           {drawn.grid[v].column, drawn.grid[v].row, drawn.vertices[v].position.x,
                            drawn.vertices[v].position.y, drawn.vertices[v].position.z});
        triangles.insert(numbers);
    }
    return triangles;
}

} // namespace testsupport
