// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

/// The layout of the 2^k triangles of a patch: the bintree's descendants k levels below a leaf, the same for
/// leaves of all sizes and directions. They are in the bintree's order (Sierpinski's curve), so that each
/// shares an edge with the one before; vertices are numbered in the order of their first use. Both serve the
/// vertex caches.
struct PatchShape
{
    /// A vertex: its distance from the apex towards left and right, in segments of the legs.
    struct Place
    {
        std::uint8_t towardsLeft, towardsRight;
    };
    using Triangle = std::array<std::uint16_t, 3>; ///< counter-clockwise seen from above, apex first

    int exponent = 0;
    int segments = 1; ///< of each edge of the leaf: 2^(k/2)
    std::vector<Place> vertices;
    std::vector<Triangle> triangles;

    /// Even exponents up to SplitBounds::kMostExponent. Threads: any.
    static const PatchShape& of(int exponent);

    GridPoint gridPoint(const GridTriangle& leaf, Place place) const
    {
        return {leaf.apex.column + ((leaf.left.column - leaf.apex.column) * place.towardsLeft +
                                    (leaf.right.column - leaf.apex.column) * place.towardsRight) /
                                       segments,
                leaf.apex.row + ((leaf.left.row - leaf.apex.row) * place.towardsLeft +
                                 (leaf.right.row - leaf.apex.row) * place.towardsRight) /
                                    segments};
    }

    /// Appends the vertices of one leaf's patch. Those on its edges are bit-identical to those of the
    /// neighbouring patches.
    void appendVertices(const PlacedTile& tile, const GridTriangle& leaf, std::vector<MeshVertex>& out) const
    {
        for (const Place place : vertices)
        {
            const GridPoint p = gridPoint(leaf, place);
            out.push_back(meshVertex(tile.position(p.column, p.row), p, tile.frame().vertexStepM()));
        }
    }

    /// Appends a leaf's patch to a mesh, with vertices of its own.
    void append(const PlacedTile& tile, const GridTriangle& leaf, DrawnMesh& mesh) const
    {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.stepM = tile.frame().vertexStepM();
        appendVertices(tile, leaf, mesh.vertices);
        for (const Place place : vertices)
            mesh.grid.push_back(gridPoint(leaf, place));
        for (const Triangle& t : triangles)
            mesh.triangles.push_back({{first + t[0], first + t[1], first + t[2]}});
    }
};

} // namespace osgTerrainROAM::core
