// SPDX-License-Identifier: Apache-2.0
#include "Envelope.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

namespace osgPMObjects::core
{

namespace
{

/// Subdivisions of a triangle before it counts as outside: by then it is so near the bound that it does not
/// matter.
constexpr int kMostHalvings = 5;

double squaredDistance(const glm::dvec3& p, const Corners& face)
{
    const glm::dvec3 away = p - nearestPoint(p, face[0], face[1], face[2]);
    return glm::dot(away, away);
}

/// Whether a triangle is within a distance of a face. Distance to a convex set is convex, so its farthest
/// corner decides.
bool isNear(const Corners& triangle, const Corners& face, double squared)
{
    return std::all_of(triangle.begin(), triangle.end(),
                       [&](const glm::dvec3& corner) { return squaredDistance(corner, face) <= squared; });
}

std::array<Corners, 4> quarters(const Corners& t)
{
    const glm::dvec3 ab = 0.5 * (t[0] + t[1]), bc = 0.5 * (t[1] + t[2]), ca = 0.5 * (t[2] + t[0]);
    return {Corners{t[0], ab, ca}, Corners{ab, t[1], bc}, Corners{ca, bc, t[2]}, Corners{ab, bc, ca}};
}

/// Whether a triangle is near a surface. `nearFace(triangle)`: whether all of it is near one face;
/// `isNearPoint(point)`: whether a point is near any face.
template<class NearFace, class NearPoint>
bool isWithin(const Corners& triangle, const NearFace& nearFace, const NearPoint& isNearPoint, int halvings)
{
    if (nearFace(triangle)) return true;
    if (halvings == 0 || !isNearPoint((triangle[0] + triangle[1] + triangle[2]) / 3.0)) return false;
    const auto parts = quarters(triangle);
    return std::all_of(parts.begin(), parts.end(),
                       [&](const Corners& part)
                       { return isWithin(part, nearFace, isNearPoint, halvings - 1); });
}

} // namespace

Envelope::Envelope(std::vector<glm::dvec3> positions, std::vector<Triangle> triangles, double distance)
    : _positions(std::move(positions)),
      _triangles(std::move(triangles)),
      _tree(_positions, _triangles),
      _distance(distance),
      _first(_positions.size(), kNone),
      _next(_triangles.size(), kNone)
{
    for (std::uint32_t t = 0; t < _triangles.size(); ++t)
    {
        _next[t] = _first[_triangles[t][0]];
        _first[_triangles[t][0]] = t;
    }
}

bool Envelope::holds(const Corners& face) const
{
    const double bound = _distance * _distance;
    const auto corners = [this](std::uint32_t t) {
        return Corners{_positions[_triangles[t][0]], _positions[_triangles[t][1]],
                       _positions[_triangles[t][2]]};
    };
    const auto nearest = [&](const glm::dvec3& p, double& squared)
    {
        std::uint32_t found = kNone;
        _tree.visitNear(p, squared,
                        [&](std::uint32_t t)
                        {
                            const double d = squaredDistance(p, corners(t));
                            if (d < squared) squared = d, found = t;
                        });
        return found;
    };
    const auto nearFace = [&](const Corners& part)
    {
        double squared = std::nextafter(bound, std::numeric_limits<double>::infinity());
        const std::uint32_t t = nearest((part[0] + part[1] + part[2]) / 3.0, squared);
        return t != kNone && isNear(part, corners(t), bound);
    };
    const auto isNearPoint = [&](const glm::dvec3& p) { return _tree.distance(p, _distance) < _distance; };
    return isWithin(face, nearFace, isNearPoint, kMostHalvings);
}

bool Envelope::isCovered(std::uint32_t triangle, std::span<const Corners> faces) const
{
    const double bound = _distance * _distance;
    const Triangle& t = _triangles[triangle];
    const auto nearFace = [&](const Corners& part)
    {
        return std::any_of(faces.begin(), faces.end(),
                           [&](const Corners& face) { return isNear(part, face, bound); });
    };
    const auto isNearPoint = [&](const glm::dvec3& p)
    {
        return std::any_of(faces.begin(), faces.end(),
                           [&](const Corners& face) { return squaredDistance(p, face) <= bound; });
    };
    return isWithin({_positions[t[0]], _positions[t[1]], _positions[t[2]]}, nearFace, isNearPoint,
                    kMostHalvings);
}

void Envelope::move(std::uint32_t triangle, std::uint32_t from, std::uint32_t to)
{
    std::uint32_t* at = &_first[from];
    while (*at != triangle)
        at = &_next[*at];
    *at = _next[triangle];
    _next[triangle] = _first[to];
    _first[to] = triangle;
}

} // namespace osgPMObjects::core
