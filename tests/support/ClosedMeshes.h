// SPDX-License-Identifier: Apache-2.0
// Closed and open meshes with positions in no plane, for tests of simplification.
#pragma once

#include <cmath>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>

#include "MadeMeshes.h"
#include "Random.h"

namespace testsupport
{

/// A ball of radius 1, closed, oriented outwards: two poles and `rings` rings of `segments` positions.
inline Mesh ball(std::uint32_t rings, std::uint32_t segments)
{
    std::vector<glm::dvec3> positions = {{0, 0, -1}, {0, 0, 1}};
    std::vector<std::array<std::uint32_t, 3>> faces;
    const auto at = [&](std::uint32_t ring, std::uint32_t i) { return 2 + ring * segments + i % segments; };
    for (std::uint32_t ring = 0; ring < rings; ++ring)
        for (std::uint32_t i = 0; i < segments; ++i)
        {
            const double height = std::numbers::pi * ((ring + 1.0) / (rings + 1.0) - 0.5);
            const double turn = 2.0 * std::numbers::pi * i / segments;
            positions.emplace_back(std::cos(height) * std::cos(turn), std::cos(height) * std::sin(turn),
                                   std::sin(height));
            if (ring + 1 == rings) continue;
            faces.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i)});
            faces.push_back({at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)});
        }
    for (std::uint32_t i = 0; i < segments; ++i)
    {
        faces.push_back({0, at(0, i + 1), at(0, i)});
        faces.push_back({1, at(rings - 1, i), at(rings - 1, i + 1)});
    }
    return meshOf(std::move(positions), faces);
}

/// A ring of radius 2 and 1, closed: one hole.
inline Mesh torus(std::uint32_t around, std::uint32_t across)
{
    std::vector<glm::dvec3> positions;
    std::vector<std::array<std::uint32_t, 3>> faces;
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % around * across + j % across; };
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < across; ++j)
        {
            const double u = 2.0 * std::numbers::pi * i / around, v = 2.0 * std::numbers::pi * j / across;
            positions.emplace_back((2.0 + std::cos(v)) * std::cos(u), (2.0 + std::cos(v)) * std::sin(u),
                                   std::sin(v));
            faces.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            faces.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return meshOf(std::move(positions), faces);
}

/// A cube from 0 to `cells` whose sides are grids of `cells` × `cells` squares, closed, oriented outwards.
inline Mesh griddedCube(int cells)
{
    std::vector<glm::dvec3> positions;
    std::vector<std::array<std::uint32_t, 3>> faces;
    std::map<std::array<int, 3>, std::uint32_t> known;
    const auto at = [&](int axis, int side, int u, int v)
    {
        std::array<int, 3> where{};
        where[axis] = side * cells;
        where[(axis + 1) % 3] = u;
        where[(axis + 2) % 3] = v;
        const auto [place, isNew] = known.try_emplace(where, static_cast<std::uint32_t>(positions.size()));
        if (isNew) positions.emplace_back(where[0], where[1], where[2]);
        return place->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side)
            for (int u = 0; u < cells; ++u)
                for (int v = 0; v < cells; ++v)
                {
                    const std::uint32_t a = at(axis, side, u, v), b = at(axis, side, u + 1, v),
                                        c = at(axis, side, u + 1, v + 1), d = at(axis, side, u, v + 1);
                    faces.push_back(side == 1 ? std::array{a, b, c} : std::array{a, c, b});
                    faces.push_back(side == 1 ? std::array{a, c, d} : std::array{a, d, c});
                }
    return meshOf(std::move(positions), faces);
}

/// Faces between positions by chance: crowded edges, duplicates, faces that fold.
inline Mesh faceSoup(std::uint64_t seed, std::uint32_t positions, std::uint32_t faces)
{
    Random random(seed);
    std::vector<glm::dvec3> places;
    for (std::uint32_t i = 0; i < positions; ++i)
        places.emplace_back(random.unit(), random.unit(), random.unit());
    std::vector<std::array<std::uint32_t, 3>> corners;
    for (std::uint32_t i = 0; i < faces; ++i)
        corners.push_back({random.below(positions), random.below(positions), random.below(positions)});
    Mesh mesh = meshOf(std::move(places), corners);
    mesh.materials.push_back({.name = "another"});
    for (std::size_t i = 0; i < mesh.faces.size(); i += 3)
        mesh.faces[i].material = 1;
    return mesh;
}

/// Gives the faces for which `isOther(centre)` a second material, and wedges of their own.
template<class IsOther>
void paint(Mesh& mesh, const IsOther& isOther)
{
    const auto other = static_cast<std::uint32_t>(mesh.materials.size());
    const auto wedges = static_cast<std::uint32_t>(mesh.wedgeCount());
    mesh.materials.push_back({.name = "other"});
    for (std::uint32_t w = 0; w < wedges; ++w)
        mesh.wedgePositions.push_back(mesh.wedgePositions[w]);
    for (auto& face : mesh.faces)
    {
        if (!isOther((mesh.at(face, 0) + mesh.at(face, 1) + mesh.at(face, 2)) / 3.0)) continue;
        face.material = other;
        for (std::uint32_t& wedge : face.wedges)
            wedge += wedges;
    }
}

} // namespace testsupport
