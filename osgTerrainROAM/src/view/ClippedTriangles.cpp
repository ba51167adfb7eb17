// SPDX-License-Identifier: Apache-2.0
// Clipping: Sutherland & Hodgman, "Reentrant polygon clipping" (1974), against the two far edges of the grid.
#include "ClippedTriangles.h"

namespace osgTerrainROAM
{

namespace
{

struct Corner
{
    glm::dvec3 position;
    glm::dvec2 grid;
};

using Polygon = std::vector<Corner>;

Polygon clipped(const Polygon& polygon, int axis, double limit)
{
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const Corner& from = polygon[i];
        const Corner& to = polygon[(i + 1) % polygon.size()];
        const bool fromInside = from.grid[axis] <= limit;
        const bool toInside = to.grid[axis] <= limit;
        if (fromInside) kept.push_back(from);
        if (fromInside == toInside) continue;
        const double t = (limit - from.grid[axis]) / (to.grid[axis] - from.grid[axis]);
        kept.push_back({glm::mix(from.position, to.position, t), glm::mix(from.grid, to.grid, t)});
    }
    return kept;
}

/// Grows the output triangle by triangle.
class Collector
{
public:
    explicit Collector(const core::RoamMesh& mesh)
        : _mesh(mesh),
          _limit(mesh.tile().tile.dataColumns() - 1, mesh.tile().tile.dataRows() - 1),
          _slotToOut(mesh.vertexSlots(), core::kNone)
    {
    }

    void add(const core::LeafTriangle& triangle)
    {
        bool inside = true;
        for (const std::uint32_t slot : triangle.vertices)
        {
            const core::GridPoint p = _mesh.tree().place(slot).point();
            inside = inside && p.column <= _limit.x && p.row <= _limit.y;
        }
        if (inside)
            for (const std::uint32_t slot : triangle.vertices)
                out.indices.push_back(shared(slot));
        else
            addClipped(triangle);
    }

    ClippedTriangles out;

private:
    Corner corner(core::VertexSlot slot) const
    {
        const core::GridPoint p = _mesh.tree().place(slot).point();
        return {_mesh.tree().position(slot), glm::dvec2(p.column, p.row)};
    }

    GLuint append(const glm::dvec3& position)
    {
        out.vertices.emplace_back(position.x, position.y, position.z);
        return static_cast<GLuint>(out.vertices.size() - 1);
    }

    GLuint shared(std::uint32_t slot)
    {
        if (_slotToOut[slot] == core::kNone) _slotToOut[slot] = append(corner(slot).position);
        return _slotToOut[slot];
    }

    void addClipped(const core::LeafTriangle& triangle)
    {
        Polygon polygon;
        for (const std::uint32_t slot : triangle.vertices)
            polygon.push_back(corner(slot));
        polygon = clipped(clipped(polygon, 0, _limit.x), 1, _limit.y);
        if (polygon.size() < 3) return;
        const GLuint first = append(polygon[0].position);
        GLuint last = append(polygon[1].position);
        for (std::size_t i = 2; i < polygon.size(); ++i)
        {
            const GLuint next = append(polygon[i].position);
            out.indices.insert(out.indices.end(), {first, last, next});
            last = next;
        }
    }

    const core::RoamMesh& _mesh;
    glm::dvec2 _limit;
    std::vector<GLuint> _slotToOut;
};

} // namespace

void ClippedTriangles::accept(osg::PrimitiveFunctor& functor) const
{
    if (indices.empty()) return;
    functor.setVertexArray(static_cast<unsigned int>(vertices.size()), vertices.data());
    functor.drawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), indices.data());
}

ClippedTriangles clippedTriangles(const core::RoamMesh& mesh, std::span<const core::TriangleRange> ranges)
{
    Collector collector(mesh);
    for (const core::TriangleRange& range : ranges)
        for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
            collector.add(mesh.triangle(slot));
    return std::move(collector.out);
}

ClippedTriangles clippedTriangles(const core::RoamMesh& mesh)
{
    std::vector<core::TriangleRange> ranges;
    for (std::uint32_t region = 0; region < mesh.tree().leaves().regionCount(); ++region)
        ranges.push_back(mesh.tree().leaves().region(region));
    return clippedTriangles(mesh, ranges);
}

} // namespace osgTerrainROAM
