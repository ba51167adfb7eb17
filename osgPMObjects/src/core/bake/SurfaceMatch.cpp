// SPDX-License-Identifier: Apache-2.0
#include "SurfaceMatch.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>

#include "../mesh/UnitVector.h"

namespace osgPMObjects::core
{

namespace
{

constexpr double kNearer =
    3.0; ///< factor by which another candidate must be nearer than the one along the normal
constexpr double kReachOfError = 1.5; ///< the error is known at corners and centres only
constexpr double kLeastReach = 1e-5;  ///< of the diagonal: rounding where the surfaces coincide

double reachOf(const TriangleTree& tree, const Mesh& full, const Mesh& simplified)
{
    double most = 0.0;
    for (const Face& face : simplified.faces)
    {
        glm::dvec3 centre(0.0);
        for (int corner = 0; corner < 3; ++corner)
        {
            most = std::max(most, tree.distance(simplified.at(face, corner)));
            centre += simplified.at(face, corner) / 3.0;
        }
        most = std::max(most, tree.distance(centre));
    }
    return kReachOfError * most + kLeastReach * diagonalOf(full);
}

} // namespace

SurfaceMatch::SurfaceMatch(const Mesh& full, const Mesh& simplified, double reach)
    : _full(full),
      _triangles(positionTriangles(full)),
      _tree(full.positions, _triangles),
      _isGone(full.parts.size(), true),
      _reach(reach > 0.0 ? reach : reachOf(_tree, full, simplified))
{
    for (const Face& face : full.faces)
    {
        const glm::dvec3 edge = full.at(face, 1) - full.at(face, 0);
        _normals.push_back(unitOr0(glm::cross(edge, full.at(face, 2) - full.at(face, 0))));
    }
    for (const Face& face : simplified.faces)
        _isGone[face.part] = false;
}

bool SurfaceMatch::isCounterpart(const Face& full, const Face& simplified) const
{
    return (full.part == simplified.part || _isGone[full.part]) &&
           _full.materials[full.material].isTransparent == _full.materials[simplified.material].isTransparent;
}

MatchedPoint SurfaceMatch::matchedPoint(const TrianglePoint& found, bool agrees) const
{
    const Triangle& t = _triangles[found.triangle];
    const glm::dvec3& a = _full.positions[t[0]];
    const glm::dvec3 ab = _full.positions[t[1]] - a, ac = _full.positions[t[2]] - a, ap = found.point - a;
    const double bb = glm::dot(ab, ab), bc = glm::dot(ab, ac), cc = glm::dot(ac, ac);
    const double determinant = bb * cc - bc * bc;
    if (determinant <= 0.0) return {found.triangle, {1.0, 0.0, 0.0}, agrees};
    const double pb = glm::dot(ap, ab), pc = glm::dot(ap, ac);
    const double v = std::clamp((cc * pb - bc * pc) / determinant, 0.0, 1.0);
    const double w = std::clamp((bb * pc - bc * pb) / determinant, 0.0, 1.0 - v);
    return {found.triangle, {1.0 - v - w, v, w}, agrees};
}

MatchedPoint SurfaceMatch::find(const glm::dvec3& point, const glm::dvec3& normal,
                                const Face& simplifiedFace) const
{
    const auto counts = [&](std::uint32_t triangle)
    { return isCounterpart(_full.faces[triangle], simplifiedFace); };
    const auto agrees = [&](std::uint32_t triangle)
    { return glm::dot(_normals[triangle], normal) > 0.0 && counts(triangle); };
    TrianglePoint best = _tree.firstHit(point, normal, _reach, std::cref(agrees));
    const double above = best.triangle == TrianglePoint::kNone ? _reach : best.distance;
    if (const TrianglePoint below = _tree.firstHit(point, -normal, above, std::cref(agrees));
        below.triangle != TrianglePoint::kNone)
        best = below;
    const bool isHit = best.triangle != TrianglePoint::kNone;
    const double most = isHit ? best.distance / kNearer : _reach;
    if (const TrianglePoint nearest = _tree.nearest(point, most, std::cref(agrees));
        nearest.triangle != TrianglePoint::kNone)
        best = nearest;
    if (best.triangle != TrianglePoint::kNone) return matchedPoint(best, true);
    constexpr double kAnywhere = std::numeric_limits<double>::infinity();
    best = _tree.nearest(point, kAnywhere, std::cref(counts));
    if (best.triangle == TrianglePoint::kNone) best = _tree.nearest(point, kAnywhere);
    return matchedPoint(best, false);
}

} // namespace osgPMObjects::core
