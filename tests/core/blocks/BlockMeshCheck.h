// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/TerrainMesh.h>

#include "SyntheticField.h"
#include "measurement/flights/BenchmarkFlight.h"

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

/// Checks that a method holds its tolerance in each frame of a flight over hills on the round Earth.
template<class Prepare>
void expectSoundOnTheRoundEarth(const Prepare& prepare)
{
    using namespace osgTerrainROAM::core;
    const auto tile =
        std::make_shared<const RoamTile>(PlacedTile(onTheEarth(hills(100, 75, 90.0)), Placement::curved));
    const auto prepared = prepare(tile);
    const auto mesh = prepared.newMesh();
    for (int frame = 0; frame < 120; frame += 8)
    {
        const auto view = measurement::BenchmarkFlight{}.view(tile->tile, frame);
        mesh->refine(view, {.errorTolerancePx = 1.0});
        ASSERT_TRUE(isSound(*mesh, view, 1.0)) << frame;
    }
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
