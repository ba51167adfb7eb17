// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <osgMultiTriangulation/core/input/Delaunay.h>
#include <osgTerrainROAM/core/bisection/BisectionPatch.h>

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kLattice = 1 << 20; ///< steps of a side

/// Where a point of the border lies on the way from the left corner to the right, the apex, and back.
double wayAlong(const glm::dvec3& w)
{
    if (w.z == 0.0 && w.y < 1.0) return w.y;
    return w.x == 0.0 && w.z < 1.0 ? 1.0 + w.z : 2.0 + w.x;
}

bool isOnBorder(const glm::dvec3& w)
{
    return w.x == 0.0 || w.y == 0.0 || w.z == 0.0;
}

/// The vertices on the sides of a triangle at the finest level, with their weights, by their way along.
std::map<double, std::pair<std::uint32_t, glm::dvec3>> bordersOf(const BisectionSurface& surface,
                                                                 Bisector carrier)
{
    std::map<double, std::pair<std::uint32_t, glm::dvec3>> border;
    const CornerVertices corners = surface.cornersOf(carrier);
    for (std::size_t c = 0; c < 3; ++c)
        border[wayAlong(kOwnCorners[c])] = {corners[c], kOwnCorners[c]};
    surface.visitWeighted(neighboursOf(surface.mesh(), carrier), kOwnCorners,
                          [&](const BisectorNeighbours&, std::uint32_t vertex, const CornerWeights& below)
                          {
                              const glm::dvec3 weights = middleOf(below);
                              if (isOnBorder(weights)) border[wayAlong(weights)] = {vertex, weights};
                              return true;
                          });
    return border;
}

std::pair<int, int> latticeOf(const glm::dvec3& weights)
{
    return {static_cast<int>(std::lround(weights.y * kLattice)),
            static_cast<int>(std::lround(weights.z * kLattice))};
}

/// Twice the area of a triangle in the plane of the weights.
double areaOf(const BisectionPatch& patch, const CornerVertices& t)
{
    const glm::dvec3 &a = patch.points[t[0]].weights, &b = patch.points[t[1]].weights,
                     &c = patch.points[t[2]].weights;
    return (b.y - a.y) * (c.z - a.z) - (c.y - a.y) * (b.z - a.z);
}

std::uint64_t keyOf(Bisector t)
{
    return std::uint64_t{t.side} << 32 | t.node;
}

} // namespace

BisectionPatch makePatch(const BisectionSurface& surface, Bisector carrier,
                         std::span<const PatchPoint> inside)
{
    BisectionPatch patch{carrier, {}, {}, {}};
    std::vector<osgMultiTriangulation::core::SurfacePoint> places;
    std::set<std::pair<int, int>> taken;
    const auto add = [&](const glm::dvec3& weights, const glm::dvec3& point)
    {
        const auto [x, y] = latticeOf(weights);
        if (!taken.emplace(x, y).second) return;
        places.push_back({x, y, 0.0});
        patch.points.push_back({weights, point});
    };
    for (const auto& [way, found] : bordersOf(surface, carrier))
    {
        patch.border.push_back(found.first);
        add(found.second, surface.point(found.first));
    }
    for (const PatchPoint& p : inside)
    {
        const auto [x, y] = latticeOf(p.weights);
        if (x > 0 && y > 0 && x + y < static_cast<int>(kLattice)) add(p.weights, p.point);
    }
    for (const auto& t : osgMultiTriangulation::core::delaunay(std::move(places)).triangles)
        patch.triangles.push_back({t[0], t[1], t[2]});
    return patch;
}

std::optional<std::string> checkPatch(const BisectionSurface& surface, const BisectionPatch& patch)
{
    const auto border = bordersOf(surface, patch.carrier);
    if (border.size() != patch.border.size() || patch.points.size() < border.size())
        return "the border has other points than the carrier";
    std::set<std::pair<std::uint32_t, std::uint32_t>> open; // sides whose other triangle has not come
    const auto count = static_cast<std::uint32_t>(border.size());
    std::uint32_t number = 0;
    for (const auto& [way, found] : border)
    {
        if (patch.border[number] != found.first || patch.points[number].weights != found.second ||
            patch.points[number].point != surface.point(found.first))
            return "point " + std::to_string(number) + " of the border is not where the surface has it";
        open.emplace((number + 1) % count, number);
        ++number;
    }
    double area = 0.0;
    for (const CornerVertices& t : patch.triangles)
    {
        for (const std::uint32_t corner : t)
            if (corner >= patch.points.size()) return "a triangle has a corner that is not there";
        if (areaOf(patch, t) <= 0.0) return "a triangle is not counter-clockwise";
        area += areaOf(patch, t);
        for (std::size_t c = 0; c < 3; ++c)
        {
            const std::uint32_t from = t[c], to = t[(c + 1) % 3];
            if (open.erase({to, from}) == 0 && !open.emplace(from, to).second)
                return "a side has two triangles in one direction";
        }
    }
    if (!open.empty()) return "a side has one triangle";
    if (std::abs(area - 1.0) > 1e-9) return "triangles cover a place twice";
    return std::nullopt;
}

CarrierTable::CarrierTable(std::span<const BisectionPatch> patches)
{
    for (std::uint32_t p = 0; p < patches.size(); ++p)
        _byCarrier.emplace(keyOf(patches[p].carrier), p);
}

std::uint32_t CarrierTable::at(Bisector t) const
{
    const auto found = _byCarrier.find(keyOf(t));
    return found == _byCarrier.end() ? kNoSide : found->second;
}

bool CarrierTable::isBelowCarrier(Bisector t) const
{
    while (t.node > 1)
        if (t = t.parent(); at(t) != kNoSide) return true;
    return false;
}

} // namespace osgTerrainROAM::core
