// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// Removes points with the triangles that have them, then the points that no triangle has. The others keep
/// their order.
/// `isThere`: by point.
inline void dropPoints(SurfaceMesh& mesh, std::vector<bool> isThere)
{
    std::erase_if(mesh.triangles,
                  [&](const Triangle& t) { return !isThere[t[0]] || !isThere[t[1]] || !isThere[t[2]]; });
    isThere.assign(mesh.points.size(), false);
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t corner : t)
            isThere[corner] = true;
    std::vector<std::uint32_t> numbers(mesh.points.size());
    std::uint32_t count = 0;
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
        numbers[p] = count;
        if (isThere[p]) mesh.points[count++] = mesh.points[p];
    }
    mesh.points.resize(count);
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& corner : t)
            corner = numbers[corner];
}

} // namespace osgMultiTriangulation::core
