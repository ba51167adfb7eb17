// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <viewlod/ScreenError.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/PlanTriangle.h>

// Faults for sound meshes, which a check must find.
namespace testsupport
{

/// A vertex that is drawn at its sample and lies in the frame; kNone: there is none.
inline std::uint32_t seenVertex(const osgTerrainROAM::core::DrawnMesh& mesh, const viewlod::ViewState& view)
{
    for (const auto& t : mesh.triangles)
    {
        const auto px = viewlod::projectPx(view, mesh.position(t.vertices[0]));
        if (px && !mesh.isSunk(t) && px->x > 0.0 && px->y > 0.0 && px->x < view.widthPx &&
            px->y < view.heightPx)
            return t.vertices[0];
    }
    return osgTerrainROAM::core::kNone;
}

/// The mesh without the triangles above and below a vertex.
inline osgTerrainROAM::core::DrawnMesh withoutTrianglesAt(osgTerrainROAM::core::DrawnMesh mesh,
                                                          std::uint32_t vertex)
{
    using osgTerrainROAM::core::PlanTriangle;
    std::erase_if(mesh.triangles,
                  [&](const auto& t)
                  {
                      return PlanTriangle{
                          {mesh.grid[t.vertices[0]], mesh.grid[t.vertices[1]], mesh.grid[t.vertices[2]]}}
                          .holds(mesh.grid[vertex]);
                  });
    return mesh;
}

/// The mesh with what is drawn at a vertex's place raised by some pixels.
inline osgTerrainROAM::core::DrawnMesh withVertexRaised(osgTerrainROAM::core::DrawnMesh mesh,
                                                        std::uint32_t vertex, const viewlod::ViewState& view,
                                                        double risePx)
{
    const double riseM = risePx * glm::distance(mesh.position(vertex), view.eyeWorld) / view.pixelsPerTangent;
    const osgTerrainROAM::core::GridPoint place = mesh.grid[vertex];
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (mesh.grid[v] == place) mesh.vertices[v].position.z += static_cast<int>(riseM / mesh.stepM);
    return mesh;
}

} // namespace testsupport
