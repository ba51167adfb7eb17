// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/Triangle.h>

namespace osgMultiTriangulation::core
{

using osgPMObjects::core::Triangle;

/// The number that stands for no point, triangle or fragment.
constexpr std::uint32_t kNone = ~0u;

/// The largest plan coordinate. Products of two differences stay below 2^53, so doubles tell exactly on which
/// side of a line a point lies.
constexpr std::int32_t kMostPlan = 1 << 26;

/// A point of a surface: a place on a lattice in the plan, and the height there.
/// Units: steps of the lattice, 0 … kMostPlan, x to the east, y to the north; metres.
struct SurfacePoint
{
    std::int32_t x = 0, y = 0;
    double height = 0.0;

    bool operator==(const SurfacePoint&) const = default;
};

/// A single-valued surface over the plan as a triangulated irregular network (TIN).
/// Triangles are counter-clockwise in the plan. checkSurface() (SurfaceCheck.h) tells whether they form a
/// triangulation.
struct SurfaceMesh
{
    std::vector<SurfacePoint> points;
    std::vector<Triangle> triangles;
};

/// Returns twice the signed area of a, b, c in the plan: positive when they are counter-clockwise. Exact.
inline double twiceArea(const SurfacePoint& a, const SurfacePoint& b, const SurfacePoint& c)
{
    const double abX = b.x - a.x, abY = b.y - a.y, acX = c.x - a.x, acY = c.y - a.y;
    return abX * acY - abY * acX;
}

} // namespace osgMultiTriangulation::core
