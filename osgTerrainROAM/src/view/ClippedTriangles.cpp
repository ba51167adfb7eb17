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
class ClipCollector
{
public:
    ClipCollector(const core::PlacedTile& tile, const core::DrawnMesh& mesh)
        : _mesh(mesh),
          _limit(tile.grid().dataColumns() - 1, tile.grid().dataRows() - 1),
          _slotToOut(mesh.vertices.size(), core::kNone)
    {
    }

    void add(const core::LeafTriangle& triangle)
    {
        bool inside = true;
        for (const std::uint32_t slot : triangle.vertices)
        {
            const core::GridPoint grid = _mesh.grid[slot];
            inside = inside && grid.column <= _limit.x && grid.row <= _limit.y;
        }
        if (inside)
            for (const std::uint32_t slot : triangle.vertices)
                out.indices.push_back(shared(slot));
        else
            addClipped(triangle);
    }

    ClippedTriangles out;

private:
    Corner corner(std::uint32_t slot) const
    {
        return {_mesh.position(slot), {_mesh.grid[slot].column, _mesh.grid[slot].row}};
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

    const core::DrawnMesh& _mesh;
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

ClippedTriangles clippedTriangles(const core::PlacedTile& tile, const core::DrawnMesh& mesh)
{
    ClipCollector collector(tile, mesh);
    for (const core::LeafTriangle& triangle : mesh.triangles)
        collector.add(triangle);
    return std::move(collector.out);
}

} // namespace osgTerrainROAM
