// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/common.hpp>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// One wedge by value; Mesh keeps wedges in parallel arrays. An attribute whose array is empty is 0.
struct Wedge
{
    std::uint32_t position = 0;
    glm::vec3 normal{};
    std::array<glm::vec2, Mesh::kTexCoordSets> texCoords{};
    glm::vec4 colour{};

    bool operator==(const Wedge&) const = default;
};

namespace detail
{

template<class Vector>
Vector valueOr0(const std::vector<Vector>& values, std::uint32_t i)
{
    return values.empty() ? Vector(0.0f) : values[i];
}

/// Appends a value to an attribute array, which stays empty as long as all values are 0. `before`: number of
/// wedges so far.
template<class Vector>
void append(std::vector<Vector>& values, std::size_t before, const Vector& value)
{
    if (values.empty())
    {
        if (value == Vector(0.0f)) return;
        values.resize(before, Vector(0.0f));
    }
    values.push_back(value);
}

} // namespace detail

inline Wedge wedgeOf(const Mesh& mesh, std::uint32_t wedge)
{
    return {mesh.wedgePositions[wedge],
            detail::valueOr0(mesh.normals, wedge),
            {detail::valueOr0(mesh.texCoords[0], wedge), detail::valueOr0(mesh.texCoords[1], wedge)},
            detail::valueOr0(mesh.colours, wedge)};
}

/// Adds a wedge and returns its number. An attribute array appears with its first value that is not 0.
inline std::uint32_t appendWedge(Mesh& mesh, const Wedge& wedge)
{
    const std::size_t before = mesh.wedgeCount();
    detail::append(mesh.normals, before, wedge.normal);
    for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
        detail::append(mesh.texCoords[set], before, wedge.texCoords[set]);
    detail::append(mesh.colours, before, wedge.colour);
    mesh.wedgePositions.push_back(wedge.position);
    return static_cast<std::uint32_t>(before);
}

/// Replaces a wedge; attributes that the mesh does not have are dropped.
inline void assignWedge(Mesh& mesh, std::uint32_t wedge, const Wedge& attributes)
{
    mesh.wedgePositions[wedge] = attributes.position;
    if (!mesh.normals.empty()) mesh.normals[wedge] = attributes.normal;
    for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
        if (!mesh.texCoords[set].empty()) mesh.texCoords[set][wedge] = attributes.texCoords[set];
    if (!mesh.colours.empty()) mesh.colours[wedge] = attributes.colour;
}

/// Interpolates between wedges as along an edge, at `t` (0…1) from a to b; the result is at `position`.
inline Wedge interpolated(const Wedge& a, const Wedge& b, float t, std::uint32_t position)
{
    Wedge between{position, glm::mix(a.normal, b.normal, t), {}, glm::mix(a.colour, b.colour, t)};
    for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
        between.texCoords[set] = glm::mix(a.texCoords[set], b.texCoords[set], t);
    return between;
}

} // namespace osgPMObjects::core
