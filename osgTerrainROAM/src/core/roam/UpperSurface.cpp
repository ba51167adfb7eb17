// SPDX-License-Identifier: Apache-2.0
#include <osgTerrainROAM/core/roam/PlanTriangle.h>
#include <osgTerrainROAM/core/roam/UpperSurface.h>

namespace osgTerrainROAM::core
{

UpperSurface::UpperSurface(const PlacedTile& tile, const DrawnMesh& mesh)
    : _columns(tile.field().columns),
      _rows(tile.field().rows),
      _points(static_cast<std::size_t>(_columns) * static_cast<std::size_t>(_rows),
              glm::dvec3(0.0, 0.0, kUncovered))
{
    const int shift = tile.grid().exponent(), step = tile.grid().cellSide();
    for (const LeafTriangle& t : mesh.triangles)
    {
        const PlanTriangle plan{
            {mesh.grid[t.vertices[0]], mesh.grid[t.vertices[1]], mesh.grid[t.vertices[2]]}};
        if (plan.doubleArea() <= 0) continue;
        const glm::dvec3 a = mesh.position(t.vertices[0]), du = mesh.position(t.vertices[1]) - a,
                         dw = mesh.position(t.vertices[2]) - a;
        plan.forEachRow(
            tile.grid().dataColumns(), tile.grid().dataRows(),
            [&](int row, int west, int east)
            {
                glm::dvec3* ofRow =
                    &_points[static_cast<std::size_t>(row >> shift) * static_cast<std::size_t>(_columns)];
                for (int column = west; column <= east; column += step)
                {
                    const auto b = plan.at(column, row);
                    const glm::dvec3 drawn = a + du * b.u + dw * b.w;
                    glm::dvec3& uppermost = ofRow[column >> shift];
                    if (drawn.z > uppermost.z) uppermost = drawn;
                }
            },
            step);
    }
}

} // namespace osgTerrainROAM::core
