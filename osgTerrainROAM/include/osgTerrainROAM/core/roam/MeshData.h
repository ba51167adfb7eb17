// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>

#include <osgTerrainROAM/core/roam/GridTriangle.h>

namespace osgTerrainROAM::core
{

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A vertex of the mesh, and the diamond around it, by its slot in the pool.
using VertexSlot = std::uint32_t;

/// A triangle of the bintree by its apex: one of the quadrants, counter-clockwise, of the diamond around that
/// vertex.
class TriangleId
{
public:
    constexpr TriangleId() = default;
    constexpr TriangleId(VertexSlot apex, unsigned quadrant) : _value(apex << 2 | quadrant) {}

    constexpr bool exists() const { return _value != kNone; }
    constexpr VertexSlot apex() const { return _value >> 2; }
    constexpr unsigned quadrant() const { return _value & 3u; }
    friend constexpr bool operator==(TriangleId, TriangleId) = default;

private:
    std::uint32_t _value = kNone;
};

/// One vertex in the format of the graphics card. The position counts steps of TileFrame::vertexStepM(), so
/// that a shader can subtract the eye (counted the same way) exactly: at 100 km from the origin a float
/// resolves 8 mm only.
/// Frame: the tile's local frame. Units: steps; columns and rows of the grid.
struct MeshVertex
{
    glm::ivec3 position{0};
    glm::u16vec2 grid{0}; ///< (column, row), the lower 16 bits of each: the rest follows from the position

    friend bool operator==(const MeshVertex&, const MeshVertex&) = default;
};
static_assert(sizeof(MeshVertex) == 16);

/// Makes the vertex of a point of the grid that is drawn at `position`, to the nearest step.
inline MeshVertex meshVertex(const glm::dvec3& position, GridPoint grid, double stepM)
{
    return {glm::ivec3(glm::round(position / stepM)), glm::u16vec2(grid.column, grid.row)};
}

inline glm::dvec3 positionOf(const MeshVertex& v, double stepM)
{
    return glm::dvec3(v.position) * stepM;
}

/// A drawn triangle: three vertex slots, counter-clockwise seen from above, apex first.
struct LeafTriangle
{
    std::uint32_t vertices[3];
};
static_assert(sizeof(LeafTriangle) == 12);

/// A whole mesh in the format of the graphics card.
struct DrawnMesh
{
    std::vector<MeshVertex> vertices;    ///< by slot, free ones included
    std::vector<GridPoint> grid;         ///< of the vertices
    std::vector<LeafTriangle> triangles; ///< in arena order
    double stepM = 0.0;                  ///< unit of the positions
    bool isMorphed = false;              ///< vertices need not lie where their samples are
    std::vector<bool> sunk = {};         ///< by vertex: it hangs below its sample; empty: none does

    /// Whether parts of the mesh lie under others: what is seen at a place is the uppermost, and edges of
    /// parts hang under others.
    bool overlaps() const { return !sunk.empty(); }
    bool isSunk(const LeafTriangle& t) const
    {
        return overlaps() && (sunk[t.vertices[0]] || sunk[t.vertices[1]] || sunk[t.vertices[2]]);
    }

    glm::dvec3 position(std::uint32_t vertex) const { return positionOf(vertices[vertex], stepM); }
};

/// Appends one element; a full vector grows by a quarter instead of doubling.
template<class Element>
Element& appendTightly(std::vector<Element>& elements, const Element& element = {})
{
    if (elements.size() == elements.capacity()) elements.reserve(elements.size() + elements.size() / 4 + 64);
    return elements.emplace_back(element);
}

/// A run of elements of an array.
struct IndexRange
{
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};
using TriangleRange = IndexRange; ///< in triangles, not in indices

/// The elements of the vertex and triangle arrays that a refinement wrote: they have to be uploaded.
struct MeshChanges
{
    std::vector<std::uint32_t> vertices;  ///< slots, in the order written, possibly repeated
    std::vector<std::uint32_t> triangles; ///< likewise
    std::vector<std::uint32_t> gone;      ///< slots of removed vertices, if they are recorded

    /// Clears; releases the memory of a single large change.
    void clear()
    {
        for (std::vector<std::uint32_t>* slots : {&vertices, &triangles, &gone})
        {
            const bool isOversized = slots->capacity() > 4096 && slots->size() < slots->capacity() / 8;
            if (isOversized) std::vector<std::uint32_t>().swap(*slots);
            slots->clear();
        }
    }
};

/// Sorts slots and joins them into ranges. Gaps of up to `maxGap` untouched elements are bridged: a few bytes
/// more are cheaper than another call.
std::vector<IndexRange> joinedRanges(std::vector<std::uint32_t> slots, std::uint32_t maxGap);

} // namespace osgTerrainROAM::core
