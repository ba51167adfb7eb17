// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <osgMultiTriangulation/core/follow/DrawnSurfaceCheck.h>

namespace osgMultiTriangulation::core
{

namespace
{

glm::dvec3 inMetres(const DrawnSurface::Vertex& v, const DrawnFrame& frame)
{
    return glm::dvec3(v[0], v[1], v[2]) * frame.vertexStep;
}

} // namespace

SurfaceMesh latticeMeshOf(const DrawnSurface& surface, const DrawnFrame& frame)
{
    SurfaceMesh mesh;
    std::unordered_map<std::uint64_t, std::uint32_t> numbers; // by place
    std::vector<std::uint32_t> points;                        // by vertex
    for (const DrawnSurface::Vertex& v : surface.vertices)
    {
        const glm::dvec3 place = inMetres(v, frame);
        const SurfacePoint point{
            frame.low[0] + static_cast<std::int32_t>(std::lround(place.x / frame.step.x)),
            frame.low[1] + static_cast<std::int32_t>(std::lround(place.y / frame.step.y)), place.z};
        const auto [found, isNew] =
            numbers.try_emplace(std::uint64_t(std::uint32_t(point.x)) << 32 | std::uint32_t(point.y),
                                static_cast<std::uint32_t>(mesh.points.size()));
        if (isNew) mesh.points.push_back(point);
        points.push_back(found->second);
    }
    for (const Triangle& t : surface.triangles)
        mesh.triangles.push_back({points[t[0]], points[t[1]], points[t[2]]});
    return mesh;
}

std::optional<std::string> checkDrawn(const DrawnSurface& surface, const DrawnFrame& frame,
                                      std::span<const OutlineSide> outline)
{
    if (auto fault = checkSurface(latticeMeshOf(surface, frame), outline)) return fault;
    std::uint32_t next = 0;
    for (const DrawnSurface::Cell& cell : surface.cells)
    {
        if (cell.firstTriangle != next) return "cells do not follow each other";
        next += cell.triangles;
        for (std::uint32_t t = cell.firstTriangle; t < std::min<std::size_t>(next, surface.triangles.size());
             ++t)
            for (const std::uint32_t corner : surface.triangles[t])
            {
                const glm::dvec3 place = inMetres(surface.vertices[corner], frame);
                if (glm::any(glm::lessThan(place, cell.low)) || glm::any(glm::greaterThan(place, cell.high)))
                    return "triangle " + std::to_string(t) + " is beyond the box of its cell";
            }
    }
    if (next != surface.triangles.size()) return "cells do not have all triangles";
    return std::nullopt;
}

double seenErrorPerDistance(const DrawnSurface& surface, const DrawnFrame& frame, const glm::dvec3& eye,
                            double nearest)
{
    double worst = 0.0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
        glm::dvec3 low(1e30), high(-1e30);
        for (const std::uint32_t corner : surface.triangles[t])
        {
            const glm::dvec3 place = inMetres(surface.vertices[corner], frame);
            low = glm::min(low, place);
            high = glm::max(high, place);
        }
        const double distance = glm::length(glm::max(glm::max(low - eye, eye - high), glm::dvec3(0.0)));
        worst = std::max(worst, surface.errors[t] / std::max(distance - surface.errors[t], nearest));
    }
    return worst;
}

} // namespace osgMultiTriangulation::core
