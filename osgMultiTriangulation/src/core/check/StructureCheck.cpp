// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include <osgMultiTriangulation/core/check/StructureCheck.h>

namespace osgMultiTriangulation::core
{

namespace
{

using Sides = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Adds the sides of a triangle, less those that are there in the opposite direction.
void addSides(Sides& sides, const Triangle& triangle)
{
    for (int c = 0; c < 3; ++c)
    {
        const std::pair side{triangle[c], triangle[(c + 1) % 3]};
        const auto opposite = std::ranges::find(sides, std::pair{side.second, side.first});
        if (opposite == sides.end())
            sides.push_back(side);
        else
            sides.erase(opposite);
    }
}

/// Whether a point lies on a side of the star's outline that its floor has as one side.
void joinAt(Sides& sides, std::uint32_t vertex)
{
    const auto in = std::ranges::find(sides, vertex, &Sides::value_type::second);
    const auto out = std::ranges::find(sides, vertex, &Sides::value_type::first);
    if (in == sides.end() || out == sides.end()) return;
    in->second = out->second;
    sides.erase(out);
}

std::optional<std::string> checkFragment(const MultiTriangulation& tree, std::uint32_t number)
{
    const std::string name = "fragment " + std::to_string(number);
    const Fragment& own = tree.fragments[number];
    const std::uint32_t vertex = tree.rootPoints + number;
    Sides star, floor;
    for (std::uint32_t t = own.firstTriangle; t < own.firstTriangle + own.triangleCount; ++t)
    {
        if (tree.upper[t] != number) return name + ": a triangle of its star does not name it";
        if (std::ranges::count(tree.corners[t], vertex) != 1)
            return name + ": a triangle of its star lacks its vertex";
        addSides(star, tree.corners[t]);
    }
    for (const std::uint32_t t : tree.floorOf(number))
    {
        if (t >= own.firstTriangle) return name + ": its floor is not there before it";
        if (tree.lower[t] != number) return name + ": a triangle of its floor does not name it";
        addSides(floor, tree.corners[t]);
    }
    if (own.triangleCount == own.floorCount + 1) joinAt(star, vertex);
    std::ranges::sort(star);
    std::ranges::sort(floor);
    if (star != floor) return name + ": star and floor do not cover the same area";
    return std::nullopt;
}

std::optional<std::string> checkSizes(const MultiTriangulation& tree)
{
    const std::size_t count = tree.corners.size();
    if (tree.errors.size() != count || tree.lower.size() != count || tree.upper.size() != count)
        return "its lists differ in length";
    if (tree.points.size() != tree.rootPoints + tree.fragments.size())
        return "a fragment has no vertex of its own";
    std::uint32_t triangle = tree.rootTriangles, floor = 0;
    for (const Fragment& own : tree.fragments)
    {
        if (own.firstTriangle != triangle || own.firstFloor != floor)
            return "its fragments do not follow each other";
        if (own.triangleCount < 2 || own.floorCount == 0) return "a fragment is empty";
        if (own.triangleCount != own.floorCount + 2 && own.triangleCount != own.floorCount + 1)
            return "a star has a wrong number of triangles";
        triangle += own.triangleCount;
        floor += own.floorCount;
    }
    if (triangle != count || floor != tree.floors.size()) return "its fragments do not fill its lists";
    return std::nullopt;
}

std::optional<std::string> checkTriangle(const MultiTriangulation& tree, std::uint32_t t)
{
    const std::string name = "triangle " + std::to_string(t);
    const std::uint32_t points =
        tree.upper[t] == kNone
            ? tree.rootPoints
            : tree.rootPoints + std::min<std::uint32_t>(tree.upper[t], tree.fragments.size() - 1) + 1;
    for (const std::uint32_t corner : tree.corners[t])
        if (corner >= points) return name + " has a corner that is not there yet";
    const Triangle& c = tree.corners[t];
    if (!(twiceArea(tree.points[c[0]], tree.points[c[1]], tree.points[c[2]]) > 0.0))
        return name + " has no area";
    if (!std::isfinite(tree.errors[t]) || tree.errors[t] < 0.0f) return name + " has no error";
    if ((t < tree.rootTriangles) != (tree.upper[t] == kNone)) return name + " has a wrong upper fragment";
    if (tree.lower[t] != kNone)
        if (tree.lower[t] >= tree.fragments.size() || std::ranges::count(tree.floorOf(tree.lower[t]), t) != 1)
            return name + " has a wrong lower fragment";
    return std::nullopt;
}

/// Whether two trees mean the same triangle, from whichever corner on.
bool isSameTriangle(const MultiTriangulation& a, const Triangle& ofA, const MultiTriangulation& b,
                    const Triangle& ofB)
{
    for (int turn = 0; turn < 3; ++turn)
        if (a.points[ofA[0]] == b.points[ofB[turn]] && a.points[ofA[1]] == b.points[ofB[(turn + 1) % 3]] &&
            a.points[ofA[2]] == b.points[ofB[(turn + 2) % 3]])
            return true;
    return false;
}

std::optional<std::string> checkPlace(const Forest& forest, const ForestTree& tree,
                                      std::vector<std::vector<bool>>& taken)
{
    const MultiTriangulation &own = tree.part, &above = forest.trees[tree.parent].part;
    if (tree.parentTriangles.size() != own.rootTriangles) return "its root is not all in its parent";
    for (std::uint32_t t = 0; t < own.rootTriangles; ++t)
    {
        const std::uint32_t at = tree.parentTriangles[t];
        if (at >= above.triangleCount() || above.lower[at] != kNone)
            return "its root is not in its parent's drain";
        if (taken[tree.parent][at]) return "its root is another tree's, too";
        taken[tree.parent][at] = true;
        if (!isSameTriangle(own, own.corners[t], above, above.corners[at]))
            return "its root has other corners than in its parent";
        if (own.errors[t] != above.errors[at]) return "its root has other errors than in its parent";
    }
    return std::nullopt;
}

} // namespace

std::optional<std::string> checkStructure(const MultiTriangulation& tree)
{
    if (auto fault = checkSizes(tree)) return fault;
    for (const std::uint32_t floor : tree.floors)
        if (floor >= tree.triangleCount()) return "a floor has a triangle that is not there";
    for (std::uint32_t t = 0; t < tree.triangleCount(); ++t)
        if (auto fault = checkTriangle(tree, t)) return fault;
    for (std::uint32_t f = 0; f < tree.fragments.size(); ++f)
        if (auto fault = checkFragment(tree, f)) return fault;
    return std::nullopt;
}

std::optional<std::string> checkStructure(const Forest& forest)
{
    std::vector<std::vector<bool>> taken;
    for (std::size_t t = 0; t < forest.trees.size(); ++t)
    {
        const ForestTree& tree = forest.trees[t];
        const std::string name = "tree " + std::to_string(t) + ": ";
        if ((t == 0) != (tree.parent == kNone) || (t > 0 && tree.parent >= t))
            return name + "it has a wrong parent";
        if (auto fault = checkStructure(tree.part)) return name + *fault;
        taken.emplace_back(tree.part.triangleCount(), false);
        if (t == 0) continue;
        if (auto fault = checkPlace(forest, tree, taken)) return name + *fault;
    }
    return std::nullopt;
}

} // namespace osgMultiTriangulation::core
