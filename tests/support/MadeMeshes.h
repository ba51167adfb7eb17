// SPDX-License-Identifier: Apache-2.0
// Small meshes for tests: one material, one part, a wedge for each position, no attributes.
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace testsupport
{

using osgPMObjects::core::Mesh;

/// A mesh of these positions and faces.
inline Mesh meshOf(std::vector<glm::dvec3> positions, const std::vector<std::array<std::uint32_t, 3>>& faces)
{
    Mesh mesh;
    mesh.positions = std::move(positions);
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i)
        mesh.wedgePositions.push_back(i);
    for (const auto& wedges : faces)
        mesh.faces.push_back({wedges, 0, 0});
    mesh.materials.push_back({.name = "material"});
    mesh.parts.push_back({"part"});
    return mesh;
}

/// A cube from (0, 0, 0) to (1, 1, 1), closed, oriented outwards.
inline Mesh cube()
{
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
    return meshOf(corners, {{0, 2, 1},
                            {1, 2, 3},
                            {4, 5, 6},
                            {5, 7, 6},
                            {0, 1, 4},
                            {1, 5, 4},
                            {2, 6, 3},
                            {3, 6, 7},
                            {0, 4, 2},
                            {2, 4, 6},
                            {1, 3, 5},
                            {3, 7, 5}});
}

/// `columns` × `rows` squares of side 1 in the plane z = 0, two triangles each, facing up.
inline Mesh grid(std::uint32_t columns, std::uint32_t rows)
{
    std::vector<glm::dvec3> positions;
    for (std::uint32_t y = 0; y <= rows; ++y)
        for (std::uint32_t x = 0; x <= columns; ++x)
            positions.emplace_back(x, y, 0.0);
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (std::uint32_t y = 0; y < rows; ++y)
        for (std::uint32_t x = 0; x < columns; ++x)
        {
            const std::uint32_t a = y * (columns + 1) + x, b = a + columns + 1;
            faces.push_back({a, a + 1, b});
            faces.push_back({a + 1, b + 1, b});
        }
    return meshOf(std::move(positions), faces);
}

} // namespace testsupport
