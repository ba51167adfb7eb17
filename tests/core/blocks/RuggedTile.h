// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include <osgTerrainROAM/core/roam/PlanTriangle.h>
#include <osgTerrainROAM/core/roam/TriangleSamples.h>

#include "BlockMeshCheck.h"
#include "SyntheticField.h"
#include "measurement/flights/BenchmarkFlight.h"

namespace testsupport
{

/// Hills for blocks, and eyes over them; `frame` may lie between two.
inline std::shared_ptr<const osgTerrainROAM::core::RoamTile> ruggedTile(int columns = 129, int rows = 129)
{
    return planarTile(hills(columns, rows, 90.0));
}

inline viewlod::ViewState viewAt(const osgTerrainROAM::core::RoamTile& tile, double frame)
{
    auto view = measurement::BenchmarkFlight{}.view(tile.tile, static_cast<int>(frame));
    view.eyeWorld += glm::dvec3(36.0, 27.0, 0.0) * (frame - std::floor(frame));
    return view;
}

/// The drawn place of every sample.
inline std::vector<glm::dvec3> drawnSamples(const osgTerrainROAM::core::TerrainMesh& mesh)
{
    const osgTerrainROAM::core::PlacedTile& tile = mesh.tile().tile;
    const int columns = tile.grid().dataColumns();
    std::vector<glm::dvec3> places(static_cast<std::size_t>(columns * tile.grid().dataRows()));
    const osgTerrainROAM::core::DrawnMesh drawn = mesh.drawn();
    for (const osgTerrainROAM::core::LeafTriangle& t : drawn.triangles)
    {
        const osgTerrainROAM::core::PlanTriangle plan{
            {drawn.grid[t.vertices[0]], drawn.grid[t.vertices[1]], drawn.grid[t.vertices[2]]}};
        const glm::dvec3 a = drawn.position(t.vertices[0]), du = drawn.position(t.vertices[1]) - a,
                         dw = drawn.position(t.vertices[2]) - a;
        forEachSampleIn(tile, plan,
                        [&](osgTerrainROAM::core::GridPoint p)
                        {
                            const auto b = plan.at(p.column, p.row);
                            places[static_cast<std::size_t>(p.row * columns + p.column)] =
                                a + du * b.u + dw * b.w;
                        });
    }
    return places;
}

} // namespace testsupport
