// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// A side of a face: 3·face + corner stands for the side from that corner to the next.
using HalfEdge = std::uint32_t;

inline std::uint32_t faceOf(HalfEdge side)
{
    return side / 3;
}

inline int cornerOf(HalfEdge side)
{
    return static_cast<int>(side % 3);
}

inline HalfEdge nextSide(HalfEdge side)
{
    return side % 3 == 2 ? side - 2 : side + 1;
}

inline HalfEdge previousSide(HalfEdge side)
{
    return side % 3 == 0 ? side + 2 : side - 1;
}

/// Faces by the positions of their corners: what connectivity is about.
std::vector<Triangle> positionTriangles(const Mesh& mesh);

/// The edge–face structure: every edge (pair of positions) with the sides of all faces that lie on it, however many.
/// Edges are in the order of their lower position, then the higher; sides of an edge in the order of their number. Sides
/// without length belong to no edge.
/// Invariant: describes() checks it against the triangles. Memory: 12 B a side. Cost: linear but for the sorting of the edges
/// around a position; 40 ms for a million faces.
/// Source: Akenine-Möller and Haines, "Real-Time Rendering", ch. 11, Consolidation (edge–face structure, sorted); we sort by
/// position numbers, not by coordinates, for positions are welded before.
class EdgeTable
{
public:
    static constexpr std::uint32_t kNone = ~0u;

    EdgeTable(std::span<const Triangle> triangles, std::size_t positionCount);

    std::uint32_t size() const { return static_cast<std::uint32_t>(_first.size() - 1); }

    /// The sides on an edge.
    std::span<const HalfEdge> sides(std::uint32_t edge) const
    {
        return {_sides.data() + _first[edge], _first[edge + 1] - _first[edge]};
    }

    /// The edge that a side lies on; kNone for a side without length.
    std::uint32_t edgeOf(HalfEdge side) const { return _edgeOfSide[side]; }

    bool isBoundary(std::uint32_t edge) const { return _first[edge + 1] - _first[edge] == 1; }
    bool isManifold(std::uint32_t edge) const { return _first[edge + 1] - _first[edge] <= 2; }

    /// Whether the table says about these triangles what it must: every side with length on exactly one edge, with the same
    /// two ends as all others on it, and no two edges with the same ends.
    bool describes(std::span<const Triangle> triangles) const;

private:
    std::vector<HalfEdge> _sides;           ///< by edge
    std::vector<std::uint32_t> _first;      ///< in _sides, by edge; one more at the end
    std::vector<std::uint32_t> _edgeOfSide; ///< by side
};

/// Where a side begins and ends.
inline std::pair<std::uint32_t, std::uint32_t> endsOf(std::span<const Triangle> triangles, HalfEdge side)
{
    const Triangle& t = triangles[faceOf(side)];
    return {t[cornerOf(side)], t[cornerOf(nextSide(side))]};
}

} // namespace osgPMObjects::core
