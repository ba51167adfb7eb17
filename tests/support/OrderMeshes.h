// SPDX-License-Identifier: Apache-2.0
// Meshes for tests of orders.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include <osgPMObjects/core/Triangle.h>

#include "Random.h"

namespace testsupport
{

struct IndexedMesh
{
    std::vector<osgPMObjects::core::Triangle> triangles;
    std::vector<glm::dvec3> positions;

    std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(positions.size()); }
};

/// Two triangles a cell, row by row, in the plane z = 0.
inline IndexedMesh gridMesh(std::uint32_t columns, std::uint32_t rows)
{
    IndexedMesh mesh;
    for (std::uint32_t y = 0; y <= rows; ++y)
        for (std::uint32_t x = 0; x <= columns; ++x)
            mesh.positions.emplace_back(x, y, 0.0);
    for (std::uint32_t y = 0; y < rows; ++y)
        for (std::uint32_t x = 0; x < columns; ++x)
        {
            const std::uint32_t v = y * (columns + 1) + x, above = v + columns + 1;
            mesh.triangles.push_back({v, v + 1, above});
            mesh.triangles.push_back({above, v + 1, above + 1});
        }
    return mesh;
}

/// A sphere of rings between two poles, closed.
inline IndexedMesh sphereMesh(std::uint32_t rings, std::uint32_t segments)
{
    IndexedMesh mesh;
    mesh.positions = {{0, 0, -1}, {0, 0, 1}};
    for (std::uint32_t r = 1; r < rings; ++r)
        for (std::uint32_t s = 0; s < segments; ++s)
        {
            const double up = std::numbers::pi * (double(r) / rings - 0.5);
            const double around = 2.0 * std::numbers::pi * s / segments;
            mesh.positions.emplace_back(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around),
                                        std::sin(up));
        }
    const auto at = [&](std::uint32_t r, std::uint32_t s) { return 2 + (r - 1) * segments + s % segments; };
    for (std::uint32_t s = 0; s < segments; ++s)
    {
        mesh.triangles.push_back({0, at(1, s + 1), at(1, s)});
        for (std::uint32_t r = 1; r + 1 < rings; ++r)
        {
            mesh.triangles.push_back({at(r, s), at(r, s + 1), at(r + 1, s)});
            mesh.triangles.push_back({at(r + 1, s), at(r, s + 1), at(r + 1, s + 1)});
        }
        mesh.triangles.push_back({1, at(rings - 1, s), at(rings - 1, s + 1)});
    }
    return mesh;
}

/// Triangles of random corners: edges with many faces, corners that are one, faces twice and turned over.
inline IndexedMesh soup(Random& random, std::uint32_t triangles, std::uint32_t vertices)
{
    IndexedMesh mesh;
    for (std::uint32_t i = 0; i < vertices; ++i)
        mesh.positions.emplace_back(random.unit(), random.unit(), random.unit());
    for (std::uint32_t i = 0; i < triangles; ++i)
        mesh.triangles.push_back({random.below(vertices), random.below(vertices), random.below(vertices)});
    return mesh;
}

inline void shuffle(IndexedMesh& mesh, Random& random)
{
    for (std::size_t i = mesh.triangles.size(); i > 1; --i)
        std::swap(mesh.triangles[i - 1], mesh.triangles[random.below(static_cast<std::uint32_t>(i))]);
}

/// Turned so that the lowest number comes first, and sorted: the same for meshes that show the same, from the
/// same sides. Triangles that show nothing are left out.
inline std::vector<osgPMObjects::core::Triangle>
orientedSet(const std::vector<osgPMObjects::core::Triangle>& triangles)
{
    std::vector<osgPMObjects::core::Triangle> turned;
    for (auto t : triangles)
    {
        if (osgPMObjects::core::repeatsCorner(t)) continue;
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        turned.push_back(t);
    }
    std::sort(turned.begin(), turned.end());
    return turned;
}

} // namespace testsupport
