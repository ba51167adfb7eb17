// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgMultiTriangulation/core/structure/StarRing.h>

namespace osgMultiTriangulation::core
{

namespace
{

/// A side in one number, which compares faster than two.
using Side = std::uint64_t;

Side sideOf(std::uint32_t from, std::uint32_t to)
{
    return Side{from} << 32 | to;
}

std::uint32_t fromOf(Side side)
{
    return static_cast<std::uint32_t>(side >> 32);
}

std::uint32_t toOf(Side side)
{
    return static_cast<std::uint32_t>(side);
}

/// The sides of a floor that only one of its triangles has.
struct FloorBorder
{
    std::array<Side, 3 * StarRing::kMost> sides{};
    std::size_t count = 0;

    void add(Side side)
    {
        const auto end = sides.begin() + count;
        const auto opposite = std::find(sides.begin(), end, sideOf(toOf(side), fromOf(side)));
        if (opposite == end)
            sides[count++] = side;
        else
            *opposite = sides[--count];
    }

    /// Puts the sides in a row. Returns whether they are one closed ring.
    bool follow(StarRing& ring) const
    {
        ring.count = count;
        Side at = sides[0];
        for (std::size_t i = 0; i < count; ++i)
        {
            ring.corners[i] = fromOf(at);
            if (std::find(ring.corners.begin(), ring.corners.begin() + i, fromOf(at)) !=
                ring.corners.begin() + i)
                return false;
            const auto next = std::find_if(sides.begin(), sides.begin() + count,
                                           [&](Side side) { return fromOf(side) == toOf(at); });
            if (next == sides.begin() + count) return false;
            at = *next;
        }
        return at == sides[0];
    }
};

bool isOnSide(const SurfacePoint& a, const SurfacePoint& b, const SurfacePoint& p)
{
    if (twiceArea(a, b, p) != 0.0) return false;
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

} // namespace

bool findStarRing(std::span<const Triangle> floor, std::span<const SurfacePoint> points,
                  const SurfacePoint& vertex, StarRing& ring)
{
    if (floor.empty() || floor.size() > StarRing::kMost - 2) return false;
    FloorBorder border;
    for (const Triangle& t : floor)
        for (int c = 0; c < 3; ++c)
            border.add(sideOf(t[c], t[(c + 1) % 3]));
    if (border.count != floor.size() + 2 || !border.follow(ring)) return false;
    const auto end = ring.corners.begin() + ring.count;
    auto first = std::min_element(ring.corners.begin(), end);
    ring.isClosed = true;
    for (std::size_t i = 0; i < ring.count; ++i)
    {
        const std::size_t next = i + 1 < ring.count ? i + 1 : 0;
        if (!isOnSide(points[ring.corners[i]], points[ring.corners[next]], vertex)) continue;
        ring.isClosed = false;
        first = ring.corners.begin() + next;
        break;
    }
    std::rotate(ring.corners.begin(), first, end);
    for (std::size_t i = 0; i < ring.triangles(); ++i)
    {
        const std::size_t next = i + 1 < ring.count ? i + 1 : 0;
        if (!(twiceArea(points[ring.corners[i]], points[ring.corners[next]], vertex) > 0.0)) return false;
    }
    return true;
}

} // namespace osgMultiTriangulation::core
