// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/consolidate/Orient.h>
#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

namespace
{

bool normalsTurn(const Mesh& mesh, const Face& face, bool isCertain)
{
    const Material& material = mesh.materials[face.material];
    if (material.isTwoSided && material.litFromBothSides) return true;
    if (material.isTwoSided && !isCertain) return false;
    const glm::dvec3 front =
        glm::cross(mesh.at(face, 1) - mesh.at(face, 0), mesh.at(face, 2) - mesh.at(face, 0));
    glm::vec3 sum(0.0f);
    for (const std::uint32_t wedge : face.wedges)
        sum += mesh.normals[wedge];
    return glm::dot(glm::dvec3(sum), front) > 0.0;
}

} // namespace

void turnFace(Mesh& mesh, std::uint32_t number, bool isCertain)
{
    const Face face = mesh.faces[number];
    Face turned = face;
    std::swap(turned.wedges[1], turned.wedges[2]);
    if (!mesh.normals.empty() && normalsTurn(mesh, face, isCertain))
        for (std::uint32_t& wedge : turned.wedges)
        {
            Wedge opposite = wedgeOf(mesh, wedge);
            opposite.normal = -opposite.normal;
            wedge = appendWedge(mesh, opposite);
        }
    mesh.faces[number] = turned;
}

} // namespace osgPMObjects::core
