// SPDX-License-Identifier: Apache-2.0
// Point to triangle: C. Ericson, "Real-Time Collision Detection" (2005), §5.1.5, as the least of the plane's foot
// point (when it falls inside) and the three edges.
#include "NearestSurface.h"

#include <algorithm>
#include <array>
#include <limits>

namespace osgTerrainROAM
{

namespace
{

using Corners = std::array<glm::dvec3, 3>;

double distanceToSegment(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(point - a, along) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(point, a + t * along);
}

double distanceToTriangle(const glm::dvec3& point, const Corners& c)
{
    const glm::dvec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
    bool inside = true;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i)
    {
        const glm::dvec3& a = c[i];
        const glm::dvec3& b = c[(i + 1) % 3];
        if (glm::dot(glm::cross(b - a, point - a), normal) < 0.0) inside = false;
        least = std::min(least, distanceToSegment(point, a, b));
    }
    const double area2 = glm::length(normal);
    if (inside && area2 > 0.0) least = std::min(least, std::abs(glm::dot(point - c[0], normal)) / area2);
    return least;
}

/// The search and the best it has found.
struct Search
{
    const core::BinTriangleTree& tree;
    glm::dvec3 point;
    double leastM;

    Corners corners(const core::BinTriangle& t) const
    {
        Corners found;
        for (int i = 0; i < 3; ++i)
        {
            const core::MeshVertex& vertex = tree.vertices()[t.vertices[i]];
            found[i] = glm::dvec3(vertex.positionHigh) + glm::dvec3(vertex.positionLow);
        }
        return found;
    }

    /// No leaf below is nearer than this.
    double boundM(const core::BinTriangle& t) const
    {
        const glm::dvec3 centre(t.bound.centre);
        double radius = t.bound.radiusM;
        for (const glm::dvec3& corner : corners(t))
            radius = std::max(radius, glm::distance(corner, centre));
        return glm::distance(point, centre) - radius;
    }

    void descend(core::NodeIndex index)
    {
        const core::BinTriangle& t = tree.node(index);
        if (!t.inData) return;
        if (t.isLeaf())
        {
            leastM = std::min(leastM, distanceToTriangle(point, corners(t)));
            return;
        }
        if (boundM(t) >= leastM) return;
        const core::NodeIndex children[2] = {t.firstChild, t.firstChild + 1};
        const bool swap = centreDistance2(children[1]) < centreDistance2(children[0]);
        descend(children[swap ? 1 : 0]);
        descend(children[swap ? 0 : 1]);
    }

    double centreDistance2(core::NodeIndex index) const
    {
        const Corners c = corners(tree.node(index));
        const glm::dvec3 away = (c[0] + c[1] + c[2]) / 3.0 - point;
        return glm::dot(away, away);
    }
};

} // namespace

double nearestSurfaceM(const core::BinTriangleTree& tree, const glm::dvec3& point)
{
    Search search{tree, point, std::numeric_limits<double>::infinity()};
    for (const core::NodeIndex root : core::BinTriangleTree::kRoots)
        search.descend(root);
    return search.leastM;
}

} // namespace osgTerrainROAM
