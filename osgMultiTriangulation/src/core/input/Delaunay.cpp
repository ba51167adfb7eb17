// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <boost/polygon/voronoi.hpp>

#include <osgMultiTriangulation/core/input/Delaunay.h>

namespace osgMultiTriangulation::core
{

SurfaceMesh delaunay(std::vector<SurfacePoint> points)
{
    boost::polygon::voronoi_builder<std::int32_t> builder;
    for (const SurfacePoint& p : points)
        builder.insert_point(p.x, p.y);
    boost::polygon::voronoi_diagram<double> diagram;
    builder.construct(&diagram);
    SurfaceMesh mesh{std::move(points), {}};
    mesh.triangles.reserve(2 * mesh.points.size());
    std::vector<std::uint32_t> around; // points on the circle of a vertex of the diagram
    for (const auto& vertex : diagram.vertices())
    {
        around.clear();
        const auto* edge = vertex.incident_edge();
        do
        {
            around.push_back(static_cast<std::uint32_t>(edge->cell()->source_index()));
            edge = edge->rot_next();
        } while (edge != vertex.incident_edge());
        for (std::size_t i = 1; i + 1 < around.size(); ++i)
        {
            const Triangle t{around[0], around[i], around[i + 1]};
            if (twiceArea(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]) > 0.0)
                mesh.triangles.push_back(t);
        }
    }
    return mesh;
}

} // namespace osgMultiTriangulation::core
