// SPDX-License-Identifier: Apache-2.0
#include "scenery/buildings/Outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenery
{

namespace
{

constexpr double kShortM = 0.05, kFlatM = 0.02;

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

bool isNeedless(const glm::dvec2& before, const glm::dvec2& at, const glm::dvec2& after)
{
    if (glm::length(at - before) < kShortM) return true;
    const glm::dvec2 chord = after - before;
    const double lengthM = glm::length(chord);
    return lengthM > kShortM && std::abs(cross(chord, at - before)) / lengthM < kFlatM &&
           glm::dot(at - before, after - at) > 0.0;
}

PlanRing withoutNeedless(const PlanRing& ring)
{
    PlanRing kept;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const glm::dvec2& before = kept.empty() ? ring.back() : kept.back();
        if (!isNeedless(before, ring[i], ring[(i + 1) % ring.size()])) kept.push_back(ring[i]);
    }
    return kept;
}

} // namespace

double turnedAreaOf(const PlanRing& ring)
{
    double area = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        area += 0.5 * cross(ring[i] - ring.front(), ring[(i + 1) % ring.size()] - ring.front());
    return area;
}

double areaOf(const std::vector<PlanRing>& rings)
{
    double area = 0.0;
    for (std::size_t i = 0; i < rings.size(); ++i)
        area += (i == 0 ? 1.0 : -1.0) * std::abs(turnedAreaOf(rings[i]));
    return area;
}

std::vector<PlanRing> tidiedRings(const std::vector<PlanRing>& rings)
{
    std::vector<PlanRing> tidied;
    for (const PlanRing& ring : rings)
    {
        PlanRing kept = withoutNeedless(ring);
        if (kept.size() < 3)
        {
            if (tidied.empty()) return {};
            continue;
        }
        if ((turnedAreaOf(kept) > 0.0) != tidied.empty()) std::reverse(kept.begin(), kept.end());
        tidied.push_back(std::move(kept));
    }
    return tidied;
}

bool isWithin(const std::vector<PlanRing>& rings, const glm::dvec2& place)
{
    bool isInside = false;
    for (const PlanRing& ring : rings)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        {
            const glm::dvec2 &a = ring[i], &b = ring[j];
            if ((a.y > place.y) != (b.y > place.y) &&
                place.x < (b.x - a.x) * (place.y - a.y) / (b.y - a.y) + a.x)
                isInside = !isInside;
        }
    return isInside;
}

PlanRectangle rectangleAround(const PlanRing& ring)
{
    PlanRectangle best;
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const glm::dvec2 edge = ring[(i + 1) % ring.size()] - ring[i];
        const double lengthM = glm::length(edge);
        if (!(lengthM > 0.0)) continue;
        const glm::dvec2 u = edge / lengthM, v(-u.y, u.x);
        glm::dvec2 low(1e300), high(-1e300);
        for (const glm::dvec2& corner : ring)
        {
            const glm::dvec2 at(glm::dot(corner - ring[0], u), glm::dot(corner - ring[0], v));
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
        const glm::dvec2 half = 0.5 * (high - low), middle = 0.5 * (low + high);
        if (half.x * half.y >= least * (1.0 - 1e-9)) continue;
        least = half.x * half.y;
        const bool isLong = half.x >= half.y;
        best = {ring[0] + u * middle.x + v * middle.y, isLong ? u : v, std::max(half.x, half.y),
                std::min(half.x, half.y)};
    }
    return best;
}

PlanRing grownRing(const PlanRing& ring, double byM)
{
    PlanRing grown;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const glm::dvec2& at = ring[i];
        const glm::dvec2 in = glm::normalize(at - ring[(i + ring.size() - 1) % ring.size()]);
        const glm::dvec2 out = glm::normalize(ring[(i + 1) % ring.size()] - at);
        const double turn = cross(in, out), straight = glm::dot(in, out);
        if (turn < 0.0 || straight < -0.7) return ring; // reflex, or so sharp that the corner would reach far
        const glm::dvec2 right(in.y + out.y, -in.x - out.x);
        grown.push_back(at + right * (byM / (1.0 + straight)));
    }
    return grown;
}

} // namespace scenery
