// SPDX-License-Identifier: Apache-2.0
#include "CarrierSearch.h"

#include <algorithm>

#include <osgMultiTriangulation/core/input/TinFile.h>

namespace osgTerrainROAM::core
{

namespace
{

/// The shares of a triangle's corners at a place, seen from above.
glm::dvec3 weightsAt(const BisectionSurface& surface, Bisector t, const glm::dvec3& p)
{
    const CornerVertices corners = surface.cornersOf(t);
    const glm::dvec3 left = surface.point(corners[0]), toRight = surface.point(corners[1]) - left,
                     toApex = surface.point(corners[2]) - left, at = p - left;
    const double area = toRight.x * toApex.y - toRight.y * toApex.x;
    const double right = (at.x * toApex.y - at.y * toApex.x) / area,
                 apex = (toRight.x * at.y - toRight.y * at.x) / area;
    return {1.0 - right - apex, right, apex};
}

bool holds(const BisectionSurface& surface, Bisector t, const std::vector<glm::dvec3>& points)
{
    constexpr double kInside = 1e-3; // points on a side would lie on the border, which has its own
    return std::ranges::all_of(points,
                               [&](const glm::dvec3& p)
                               {
                                   const glm::dvec3 w = weightsAt(surface, t, p);
                                   return w.x > kInside && w.y > kInside && w.z > kInside;
                               });
}

} // namespace

bool isWithin(Bisector t, Bisector outer)
{
    return t.side == outer.side && t.level() >= outer.level() &&
           t.node >> (t.level() - outer.level()) == outer.node;
}

foundation::Result<BisectionPatch> readPatch(const BisectionSurface& surface,
                                             const std::filesystem::path& file)
{
    const auto tin = osgMultiTriangulation::core::readTinFile(file);
    if (!tin) return tin.error();
    std::vector<glm::dvec3> points;
    for (const auto& point : tin->points)
        points.emplace_back(point[0], point[1], point[2]);
    Bisector carrier{kNoSide, 1};
    for (std::uint32_t side = 0; side < surface.mesh().sides() && carrier.side == kNoSide; ++side)
        if (holds(surface, {side, 1}, points)) carrier = {side, 1};
    if (carrier.side == kNoSide)
        return foundation::Error{file.string(), "lies in no triangle of the coarse mesh",
                                 "move it, or give a mesh with a triangle around it"};
    for (bool isDeeper = true; isDeeper && carrier.level() + 2 < surface.levels();)
    {
        isDeeper = false;
        for (const int half : {0, 1})
            if (!isDeeper && holds(surface, carrier.half(half), points))
            {
                carrier = carrier.half(half);
                isDeeper = true;
            }
    }
    std::vector<PatchPoint> inside;
    for (const glm::dvec3& p : points)
        inside.push_back({weightsAt(surface, carrier, p), p});
    BisectionPatch patch = makePatch(surface, carrier, inside);
    if (const auto fault = checkPatch(surface, patch))
        return foundation::Error{file.string(), *fault, "simplify it"};
    return patch;
}

} // namespace osgTerrainROAM::core
