// SPDX-License-Identifier: Apache-2.0
#include "compare/objects/CheckerCoordinates.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/Wedge.h>

namespace pmtool
{

namespace
{

using namespace osgPMObjects;

/// 0 to 5: the side of a cube that a face looks at.
int sideOf(const core::Mesh& mesh, const core::Face& face)
{
    const glm::dvec3 normal =
        glm::cross(mesh.at(face, 1) - mesh.at(face, 0), mesh.at(face, 2) - mesh.at(face, 0));
    const glm::dvec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return 2 * axis + (normal[axis] < 0.0);
}

/// Charts are this far apart: no two of a part agree by chance, and the coordinates are short in binary.
glm::dvec2 placeOf(int side, std::uint32_t part)
{
    return {1.25 * side + 0.125 * (part % 8), 0.375 * side};
}

} // namespace

void addCheckerCoordinates(core::Mesh& mesh)
{
    const core::Extent box = core::extentOf(mesh.positions);
    const glm::dvec3 size = box.high - box.low;
    const double unit = std::max({size.x, size.y, size.z, 1e-300});
    core::Mesh charted = mesh;
    charted.wedgePositions.clear(), charted.normals.clear(), charted.colours.clear();
    for (auto& texCoords : charted.texCoords)
        texCoords.clear();
    std::unordered_map<std::uint64_t, std::uint32_t> wedges; // by wedge, part and side
    for (core::Face& face : charted.faces)
    {
        const int side = sideOf(mesh, face), first = side / 2 == 0 ? 1 : 0, second = side / 2 == 2 ? 1 : 2;
        for (std::uint32_t& number : face.wedges)
        {
            const std::uint64_t chart = 8 * (face.part % 8) + static_cast<std::uint64_t>(side);
            const auto [at, isNew] = wedges.try_emplace(64 * std::uint64_t(number) + chart,
                                                        static_cast<std::uint32_t>(charted.wedgeCount()));
            if (isNew)
            {
                core::Wedge wedge = core::wedgeOf(mesh, number);
                const glm::dvec3 p = (mesh.positions[wedge.position] - box.low) / unit;
                wedge.texCoords[0] = glm::vec2(placeOf(side, face.part) + glm::dvec2(p[first], p[second]));
                core::appendWedge(charted, wedge);
            }
            number = at->second;
        }
    }
    for (core::Material& material : charted.materials)
    {
        material.attributes |= core::Material::texCoord0;
        material.unseen &= ~std::uint32_t(core::Material::texCoord0);
    }
    mesh = std::move(charted);
}

} // namespace pmtool
