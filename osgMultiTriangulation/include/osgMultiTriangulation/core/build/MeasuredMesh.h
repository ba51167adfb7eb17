// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// A triangulation together with the points of the full surface that it no longer has, each at the triangle
/// above or below which it lies. So the vertical error of every triangle is known over all points.
struct MeasuredMesh
{
    SurfaceMesh mesh;
    std::vector<float> errors; ///< by triangle, metres: at least its error at each of its hidden points
    std::vector<SurfacePoint> hidden;       ///< by triangle, the worst first
    std::vector<std::uint32_t> firstHidden; ///< by triangle, and one more: where its hidden points begin

    std::span<const SurfacePoint> hiddenOf(std::uint32_t triangle) const
    {
        return std::span(hidden).subspan(firstHidden[triangle],
                                         firstHidden[triangle + 1] - firstHidden[triangle]);
    }
};

/// Returns a mesh that hides no point.
inline MeasuredMesh fullMesh(SurfaceMesh mesh)
{
    MeasuredMesh full{std::move(mesh), {}, {}, {}};
    full.errors.assign(full.mesh.triangles.size(), 0.0f);
    full.firstHidden.assign(full.mesh.triangles.size() + 1, 0);
    return full;
}

} // namespace osgMultiTriangulation::core
