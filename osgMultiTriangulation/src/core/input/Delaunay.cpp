// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <osgMultiTriangulation/core/input/Delaunay.h>

#include "CirclePolygons.h"

namespace osgMultiTriangulation::core
{

SurfaceMesh delaunay(std::vector<SurfacePoint> points)
{
    SurfaceMesh mesh{std::move(points), {}};
    mesh.triangles.reserve(2 * mesh.points.size());
    visitCirclePolygons(mesh.points,
                        [&mesh](std::span<const std::uint32_t> around, double, double)
                        {
                            for (std::size_t i = 1; i + 1 < around.size(); ++i)
                            {
                                const Triangle t{around[0], around[i], around[i + 1]};
                                if (twiceArea(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]) > 0.0)
                                    mesh.triangles.push_back(t);
                            }
                        });
    return mesh;
}

} // namespace osgMultiTriangulation::core
