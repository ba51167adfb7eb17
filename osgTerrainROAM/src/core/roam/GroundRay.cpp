// SPDX-License-Identifier: Apache-2.0
// Descends the bintree along a ray. The surface below a triangle is within e_v of it: within a sphere about
// the middle of its base, and within a slab about its plane. A ray that is never in both at once misses it.
#include <algorithm>
#include <cmath>
#include <limits>

#include <osgTerrainROAM/core/heightfield/VerticalHit.h>
#include <osgTerrainROAM/core/roam/GridTriangle.h>
#include <osgTerrainROAM/core/roam/GroundRay.h>
#include <osgTerrainROAM/core/roam/Outline.h>

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kNowhere = std::numeric_limits<double>::infinity();
constexpr double kBoundSlack = 1.0 + 1e-6;

/// A triangle with the positions of its corners.
struct PlacedTriangle
{
    GridTriangle grid;
    glm::dvec3 apex, left, right;
};

class Cast
{
public:
    Cast(const RoamTile& tile, const glm::dvec3& origin, const glm::dvec3& direction, double maxDistanceM)
        : _tile(tile), _origin(origin), _direction(direction), _nearestM(maxDistanceM)
    {
    }

    std::optional<GroundHit> nearest()
    {
        for (const GridTriangle& root : rootTriangles(_tile.tile.grid().side()))
            visit({root, position(root.apex), position(root.left), position(root.right)}, 0);
        if (!_normal) return std::nullopt;
        return GroundHit{_nearestM, _origin + _nearestM * _direction,
                         _normal->z < 0.0 ? -*_normal : *_normal};
    }

private:
    glm::dvec3 position(GridPoint p) const { return _tile.tile.position(p.column, p.row); }

    void visit(const PlacedTriangle& t, int level)
    {
        if (!t.grid.overlaps(_tile.tile.grid().dataColumns(), _tile.tile.grid().dataRows())) return;
        if (level == _tile.tile.grid().levels())
        {
            if (isDrawn(_tile.tile, t.grid)) meet(t);
            return;
        }
        const auto halves = t.grid.children();
        const GridPoint mid = halves[0].apex;
        if (entry(t, _tile.bound(mid).errorM) > _nearestM) return;
        const glm::dvec3 top = position(mid);
        const PlacedTriangle children[2] = {{halves[0], top, t.apex, t.left},
                                            {halves[1], top, t.right, t.apex}};
        // The nearer half first: its hit shortens the search of the other.
        const int first = glm::dot(_direction, t.left - t.right) > 0.0 ? 1 : 0;
        visit(children[first], level + 1);
        visit(children[1 - first], level + 1);
    }

    /// Returns the distance at which the ray enters the bounds of the surface below `t`; kNowhere: never.
    double entry(const PlacedTriangle& t, double errorM) const
    {
        const glm::dvec3 centre = 0.5 * (t.left + t.right);
        const double radius =
            (std::max(glm::distance(centre, t.apex), glm::distance(centre, t.left)) + errorM) * kBoundSlack;
        const glm::dvec3 offset = centre - _origin;
        const double along = glm::dot(offset, _direction);
        const double half2 = radius * radius - (glm::dot(offset, offset) - along * along);
        if (half2 < 0.0) return kNowhere;
        const double half = std::sqrt(half2);
        double from = std::max(along - half, 0.0), to = along + half;

        const glm::dvec3 normal = glm::normalize(glm::cross(t.left - t.apex, t.right - t.apex));
        const double height = glm::dot(_origin - t.apex, normal), climb = glm::dot(_direction, normal);
        const double thickness = errorM * kBoundSlack + 1e-9 * radius;
        if (std::fabs(climb) < 1e-12)
            return std::fabs(height) <= thickness + 1e-6 * radius && from <= to ? from : kNowhere;
        const double a = (-thickness - height) / climb, b = (thickness - height) / climb;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
        return from <= to ? from : kNowhere;
    }

    /// Source: Möller & Trumbore, *Fast, minimum storage ray-triangle intersection*, 1997.
    void meet(const PlacedTriangle& t)
    {
        const glm::dvec3 e1 = t.left - t.apex, e2 = t.right - t.apex, p = glm::cross(_direction, e2);
        const double volume = glm::dot(e1, p);
        if (volume == 0.0) return; // the ray runs in the plane: an edge's neighbour meets it
        const glm::dvec3 offset = _origin - t.apex, q = glm::cross(offset, e1);
        const double u = glm::dot(offset, p) / volume, v = glm::dot(_direction, q) / volume;
        if (u < -kEdgeSlack || v < -kEdgeSlack || u + v > 1.0 + kEdgeSlack) return;
        const double distance = glm::dot(e2, q) / volume;
        if (distance < 0.0 || distance > _nearestM) return;
        _nearestM = distance;
        _normal = glm::normalize(glm::cross(e1, e2));
    }

    const RoamTile& _tile;
    const glm::dvec3 _origin, _direction;
    double _nearestM;
    std::optional<glm::dvec3> _normal; ///< of the triangle met at _nearestM
};

} // namespace

std::optional<GroundHit> hitGround(const RoamTile& tile, const glm::dvec3& origin,
                                   const glm::dvec3& direction, double maxDistanceM)
{
    return Cast(tile, origin, direction, maxDistanceM).nearest();
}

} // namespace osgTerrainROAM::core
