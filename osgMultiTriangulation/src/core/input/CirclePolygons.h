// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <boost/polygon/voronoi.hpp>

#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// Calls visit(numbers, x, y) for each circle with no point inside it and three or more on it: these points
/// counter-clockwise, and the centre. Fans of them are the Delaunay triangulation.
/// Source: the vertices of the Voronoi diagram of Boost.Polygon (Fortune's sweep with exact predicates on
/// whole numbers).
template<class Visit>
void visitCirclePolygons(std::span<const SurfacePoint> points, const Visit& visit)
{
    boost::polygon::voronoi_builder<std::int32_t> builder;
    for (const SurfacePoint& p : points)
        builder.insert_point(p.x, p.y);
    boost::polygon::voronoi_diagram<double> diagram;
    builder.construct(&diagram);
    std::vector<std::uint32_t> around;
    for (const auto& vertex : diagram.vertices())
    {
        around.clear();
        const auto* edge = vertex.incident_edge();
        do
        {
            around.push_back(static_cast<std::uint32_t>(edge->cell()->source_index()));
            edge = edge->rot_next();
        } while (edge != vertex.incident_edge());
        visit(std::span<const std::uint32_t>(around), vertex.x(), vertex.y());
    }
}

} // namespace osgMultiTriangulation::core
