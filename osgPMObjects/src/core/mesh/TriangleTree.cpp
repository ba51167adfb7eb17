// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <thread>
#include <utility>

#include <foundation/Threads.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/TriangleTree.h>

namespace osgPMObjects::core
{

namespace
{

/// The least number of triangles for which two threads build the halves of a tree.
constexpr std::uint32_t kLeastShared = 16384;
constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

/// Whether a ray enters a box before `most` lengths; `inverse`: reciprocal coordinates of its direction.
bool meets(const Extent& box, const glm::dvec3& from, const glm::dvec3& inverse, double most)
{
    const glm::dvec3 a = (box.low - from) * inverse, b = (box.high - from) * inverse;
    const glm::dvec3 near = glm::min(a, b), far = glm::max(a, b);
    const double enters = std::max({near.x, near.y, near.z, 0.0}), leaves = std::min({far.x, far.y, far.z});
    return enters <= most && enters <= leaves * (1.0 + 1e-12);
}

} // namespace

TriangleTree::TriangleTree(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles)
    : _positions(positions), _triangles(triangles), _order(triangles.size())
{
    std::iota(_order.begin(), _order.end(), 0u);
    std::vector<glm::dvec3> centres;
    centres.reserve(triangles.size());
    for (const Triangle& t : triangles)
        centres.push_back((positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3.0);
    _nodes.reserve(triangles.size());
    const auto count = static_cast<std::uint32_t>(triangles.size());
    if (count > 0) build(0, count, centres, foundation::processors(), _nodes);
}

void TriangleTree::build(std::uint32_t first, std::uint32_t last, std::span<const glm::dvec3> centres,
                         unsigned threads, std::vector<Node>& nodes)
{
    const std::size_t number = nodes.size();
    nodes.emplace_back();
    Extent spread;
    for (std::uint32_t i = first; i < last; ++i)
    {
        spread.add(centres[_order[i]]);
        for (const std::uint32_t p : _triangles[_order[i]])
            nodes[number].box.add(_positions[p]);
    }
    if (last - first <= kLeafSize)
    {
        nodes[number].first = first;
        nodes[number].count = last - first;
        return;
    }
    const glm::dvec3 size = spread.high - spread.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(_order.begin() + first, _order.begin() + middle, _order.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b)
                     {
                         const double x = centres[a][axis], y = centres[b][axis];
                         return x != y ? x < y : a < b;
                     });
    const bool isShared = threads > 1 && last - first >= kLeastShared;
    std::vector<Node> others; // of the second half, numbered from 0, when another thread builds it
    foundation::Threads other;
    if (isShared) other.run([&] { build(middle, last, centres, threads / 2, others); });
    build(first, middle, centres, isShared ? threads - threads / 2 : 1, nodes);
    const auto second = static_cast<std::uint32_t>(nodes.size());
    nodes[number].first = second;
    if (!isShared) return build(middle, last, centres, 1, nodes);
    other.join();
    for (Node& node : others)
        if (node.count == 0) node.first += second;
    nodes.insert(nodes.end(), others.begin(), others.end());
}

double TriangleTree::distance(const glm::dvec3& point, double most) const
{
    std::uint64_t all = kUnlimited;
    return *distance(point, most, all);
}

std::optional<double> TriangleTree::distance(const glm::dvec3& point, double most, std::uint64_t& work) const
{
    double best = most * most;
    visitNear(point, best,
              [&](std::uint32_t triangle)
              {
                  if (work == 0) best = 0.0; // ends the visit
                  if (work == 0) return;
                  --work;
                  const Triangle& t = _triangles[triangle];
                  const glm::dvec3 away =
                      point - nearestPoint(point, _positions[t[0]], _positions[t[1]], _positions[t[2]]);
                  best = std::min(best, glm::dot(away, away));
              });
    if (work == 0) return {};
    return std::sqrt(best);
}

TrianglePoint TriangleTree::nearest(const glm::dvec3& point, double most, const Accepts& accepts) const
{
    TrianglePoint found;
    double best = most * most;
    visitNear(point, best,
              [&](std::uint32_t triangle)
              {
                  const Triangle& t = _triangles[triangle];
                  const glm::dvec3 at =
                      nearestPoint(point, _positions[t[0]], _positions[t[1]], _positions[t[2]]);
                  const double squared = glm::dot(point - at, point - at);
                  if (!(squared < best) || (accepts && !accepts(triangle))) return;
                  best = squared;
                  found = {triangle, at, std::sqrt(squared)};
              });
    return found;
}

template<class Look>
bool TriangleTree::follow(const glm::dvec3& from, const glm::dvec3& direction, const double& most,
                          std::uint64_t& work, const Look& look) const
{
    if (_nodes.empty()) return false;
    const glm::dvec3 inverse = 1.0 / direction;
    std::array<std::uint32_t, kStack> stack;
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0 && work > 0)
    {
        --work;
        const std::uint32_t number = stack[--depth];
        const Node& node = _nodes[number];
        if (!meets(node.box, from, inverse, most)) continue;
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        {
            const Triangle& t = _triangles[_order[i]];
            if (look(_order[i],
                     rayDistance(from, direction, _positions[t[0]], _positions[t[1]], _positions[t[2]])))
                return true;
        }
        if (node.count > 0) continue;
        stack[depth++] = node.first;
        stack[depth++] = number + 1;
    }
    return false;
}

TrianglePoint TriangleTree::firstHit(const glm::dvec3& from, const glm::dvec3& direction, double most,
                                     const Accepts& accepts) const
{
    TrianglePoint found;
    double best = most;
    std::uint64_t all = kUnlimited;
    follow(from, direction, best, all,
           [&](std::uint32_t triangle, double distance)
           {
               if (distance < 0.0 || distance >= best || (accepts && !accepts(triangle))) return false;
               best = distance;
               found = {triangle, from + distance * direction, distance};
               return false;
           });
    return found;
}

bool TriangleTree::isHit(const glm::dvec3& from, const glm::dvec3& direction, double least) const
{
    std::uint64_t all = kUnlimited;
    return *isHit(from, direction, least, all);
}

std::optional<bool> TriangleTree::isHit(const glm::dvec3& from, const glm::dvec3& direction, double least,
                                        std::uint64_t& work) const
{
    const bool found = follow(from, direction, std::numeric_limits<double>::infinity(), work,
                              [&](std::uint32_t, double distance) { return distance > least; });
    if (!found && work == 0) return {};
    return found;
}

} // namespace osgPMObjects::core
