// SPDX-License-Identifier: Apache-2.0
// Point to triangle: C. Ericson, "Real-Time Collision Detection" (2005), §5.1.5, as the least of the plane's
// foot point (when it falls inside) and the three edges.
#include <algorithm>
#include <array>
#include <limits>

#include <foundation/NearestOnSegment.h>

#include <osgTerrainROAM/core/roam/NearestSurface.h>
#include <osgTerrainROAM/core/roam/Outline.h>

namespace osgTerrainROAM::core
{

namespace
{

using Corners = std::array<glm::dvec3, 3>;

double distanceToSegment(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::distance(point, foundation::nearestOnSegment(point, a, b));
}

/// The search and the best it has found.
struct SurfaceSearch
{
    const DiamondTree& tree;
    glm::dvec3 point;
    double leastM;

    glm::dvec3 position(GridPoint p) const { return tree.tile().tile.position(p.column, p.row); }

    Corners corners(const GridTriangle& t) const
    {
        return {position(t.apex), position(t.left), position(t.right)};
    }

    /// No leaf below is nearer than this.
    double boundM(const SplitBound& bound, const Corners& corners) const
    {
        const glm::dvec3 centre(bound.centre);
        double radius = bound.radiusM;
        for (const glm::dvec3& corner : corners)
            radius = std::max(radius, glm::distance(corner, centre));
        return glm::distance(point, centre) - radius;
    }

    /// Into a leaf's patch.
    void descendPatch(const GridTriangle& g, const Corners& c, int level)
    {
        const RoamTile& tile = tree.tile();
        if (!g.overlaps(tile.tile.grid().dataColumns(), tile.tile.grid().dataRows())) return;
        if (level == tree.bounds().patchExponent())
        {
            leastM = std::min(leastM, distanceToTriangleM(point, c));
            return;
        }
        if (boundM(tile.bound(g.middleOfBase()), c) >= leastM) return;
        for (const GridTriangle& half : g.children())
            descendPatch(half, corners(half), level + 1);
    }

    void descend(TriangleId t, const GridTriangle& g)
    {
        const PlacedTile& tile = tree.tile().tile;
        if (!g.overlaps(tile.grid().dataColumns(), tile.grid().dataRows())) return;
        const Corners c = corners(g);
        if (tree.isLeaf(t) && tree.bounds().patchExponent() > 0) return descendPatch(g, c, 0);
        if (tree.isLeaf(t))
        {
            if (!isDrawn(tile, g)) return;
            Corners drawn;
            const LeafTriangle leaf = tree.vertices(t);
            std::transform(std::begin(leaf.vertices), std::end(leaf.vertices), drawn.begin(),
                           [this](VertexSlot v) { return tree.position(v); });
            leastM = std::min(leastM, distanceToTriangleM(point, drawn));
            return;
        }
        if (boundM(tree.bound(t), c) >= leastM) return;
        // The nearer half first: the children share apex and middle, and differ by the base's ends.
        const bool rightFirst = glm::distance(point, c[2]) < glm::distance(point, c[1]);
        const auto children = tree.children(t);
        const auto halves = g.children();
        for (const std::size_t half : {rightFirst ? 1u : 0u, rightFirst ? 0u : 1u})
            descend(children[half], halves[half]);
    }
};

} // namespace

double distanceToTriangleM(const glm::dvec3& point, const std::array<glm::dvec3, 3>& c)
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

double nearestSurfaceM(const DiamondTree& tree, const glm::dvec3& point)
{
    SurfaceSearch search{tree, point, std::numeric_limits<double>::infinity()};
    for (const TriangleId root : DiamondTree::kRoots)
        search.descend(root, tree.gridTriangle(root));
    return search.leastM;
}

} // namespace osgTerrainROAM::core
