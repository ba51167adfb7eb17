// SPDX-License-Identifier: Apache-2.0
#include "compare/objects/SimplifyTool.h"

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/MeshBuilder.h>

namespace pmtool
{

using namespace osgPMObjects;

std::vector<SimplifyTool> simplifyTools()
{
    std::vector<SimplifyTool> tools;
    addOwnTools(tools);
    tools.push_back({"meshoptimizer", true, meshoptimizerLevels});
    tools.push_back({"osgUtil", true, osgUtilLevels});
    return tools;
}

core::Mesh shapeOf(std::span<const glm::dvec3> positions, std::span<const core::Triangle> triangles)
{
    core::MeshBuilder builder;
    const std::uint32_t material = builder.material({.name = "shape"}), part = builder.part("shape");
    const auto wedgeAt = [&](std::uint32_t p)
    {
        const std::uint32_t position = builder.position(positions[p]);
        return position < builder.mesh().wedgeCount() ? position : builder.wedge({.position = position});
    };
    for (const core::Triangle& t : triangles)
    {
        const core::Triangle wedges{wedgeAt(t[0]), wedgeAt(t[1]), wedgeAt(t[2])};
        if (!core::repeatsCorner(wedges)) builder.face({wedges, material, part});
    }
    return builder.finish();
}

core::Mesh shapeOf(const core::Mesh& mesh)
{
    return shapeOf(mesh.positions, core::positionTriangles(mesh));
}

} // namespace pmtool
