// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Whether faces of a material have texture coordinates, set 0.
inline bool isTextured(const Mesh& mesh, std::uint32_t material)
{
    return !mesh.texCoords[0].empty() && mesh.materials[material].has(Material::texCoord0);
}

/// Returns the texture coordinates of a point of a face, set 0: corner 0 + second·(corner 1 - corner 0) +
/// third·(corner 2 - corner 0).
inline glm::dvec2 texCoordAt(const Mesh& mesh, std::uint32_t face, double second, double third)
{
    const auto at = [&](int corner)
    { return glm::dvec2(mesh.texCoords[0][mesh.faces[face].wedges[corner]]); };
    return at(0) + second * (at(1) - at(0)) + third * (at(2) - at(0));
}

} // namespace osgPMObjects::core
