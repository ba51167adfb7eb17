// SPDX-License-Identifier: Apache-2.0
#include "HiddenWalk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <foundation/Random.h>

#include <osgMultiTriangulation/core/structure/ErrorCode.h>

namespace osgMultiTriangulation::core
{

namespace
{

std::uint32_t chanceOf(const SurfacePoint& point)
{
    return static_cast<std::uint32_t>(
        foundation::mixedBits(std::uint64_t(std::uint32_t(point.x)) << 32 | std::uint32_t(point.y)));
}

} // namespace

float verticalDistance(const SurfacePoint& point, const SurfacePoint& a, const SurfacePoint& b,
                       const SurfacePoint& c)
{
    const double onA = twiceArea(b, c, point), onB = twiceArea(c, a, point), onC = twiceArea(a, b, point);
    const double height = (a.height * onA + b.height * onB + c.height * onC) / (onA + onB + onC);
    const double error = std::abs(height - point.height);
    const auto near = static_cast<float>(error);
    return near < error ? std::nextafter(near, std::numeric_limits<float>::max()) : near;
}

HiddenWalk::HiddenWalk(MultiTriangulation& tree) : _tree(tree)
{
    for (std::uint32_t t = 0; t < tree.triangleCount(); ++t)
        if (tree.lower[t] != kNone) tree.errors[t] = 0.0f;
}

std::uint32_t HiddenWalk::climb(const SurfacePoint& point, std::uint32_t triangle, float& errorM)
{
    errorM = _tree.errors[triangle]; // of a triangle that is in the root already: no less than it is
    while (_tree.upper[triangle] != kNone)
        triangle = floorUnder(point, _tree.upper[triangle], errorM);
    return triangle;
}

std::uint32_t HiddenWalk::climbFrom(std::uint32_t fragment, float& errorM)
{
    const SurfacePoint point = _tree.points[_tree.rootPoints + fragment];
    return climb(point, floorUnder(point, fragment, errorM), errorM);
}

std::uint32_t HiddenWalk::floorUnder(const SurfacePoint& point, std::uint32_t fragment, float& errorM)
{
    const std::span<const std::uint32_t> floor = _tree.floorOf(fragment);
    for (std::size_t f = 0; f < floor.size(); ++f)
    {
        const Triangle& t = _tree.corners[floor[f]];
        const SurfacePoint &a = _tree.points[t[0]], &b = _tree.points[t[1]], &c = _tree.points[t[2]];
        const bool isIn =
            twiceArea(b, c, point) >= 0.0 && twiceArea(c, a, point) >= 0.0 && twiceArea(a, b, point) >= 0.0;
        if (!isIn && f + 1 < floor.size()) continue; // it lies in one of them
        errorM = verticalDistance(point, a, b, c);
        _tree.errors[floor[f]] = std::max(_tree.errors[floor[f]], errorM);
        return floor[f];
    }
    return floor.back();
}

void HiddenWalk::finish()
{
    for (float& error : _tree.errors)
        error = errorOfCode(codeOfError(error));
}

HiddenSelection::HiddenSelection(std::uint32_t triangles, std::uint32_t perTriangle)
    : _perTriangle(std::max(2u, perTriangle)), _kept(triangles)
{
}

void HiddenSelection::add(std::uint32_t triangle, const SurfacePoint& point, float errorM)
{
    // The first half holds the worst, the second half those of the least chance among the others.
    std::vector<Kept>& kept = _kept[triangle];
    const std::size_t worst = _perTriangle / 2;
    const auto isWorse = [](const Kept& a, const Kept& b)
    {
        if (a.errorM != b.errorM) return a.errorM > b.errorM;
        return std::pair(a.point.x, a.point.y) < std::pair(b.point.x, b.point.y);
    };
    const auto isSooner = [](const Kept& a, const Kept& b)
    {
        if (a.chance != b.chance) return a.chance < b.chance;
        return std::pair(a.point.x, a.point.y) < std::pair(b.point.x, b.point.y);
    };
    Kept next{point, errorM, chanceOf(point)};
    std::size_t place = 0;
    while (place < std::min(worst, kept.size()) && !isWorse(next, kept[place]))
        ++place;
    if (place < worst)
    {
        kept.insert(kept.begin() + static_cast<std::ptrdiff_t>(place), next);
        if (kept.size() <= worst) return;
        next = kept[worst]; // falls out of the worst
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(worst));
    }
    const auto from = kept.begin() + static_cast<std::ptrdiff_t>(worst);
    kept.insert(std::lower_bound(from, kept.end(), next, isSooner), next);
    if (kept.size() > _perTriangle) kept.pop_back();
}

void HiddenSelection::moveInto(MeasuredMesh& mesh)
{
    mesh.hidden.clear();
    mesh.firstHidden.assign(1, 0);
    for (std::vector<Kept>& kept : _kept)
    {
        for (const Kept& point : kept)
            mesh.hidden.push_back(point.point);
        std::vector<Kept>().swap(kept);
        mesh.firstHidden.push_back(static_cast<std::uint32_t>(mesh.hidden.size()));
    }
}

} // namespace osgMultiTriangulation::core
