// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <glm/vec2.hpp>

namespace osgRoads::core
{

/// An axis-aligned box in the plan view.
struct PlanBox
{
    glm::dvec2 least{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    glm::dvec2 most{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};

    void include(glm::dvec2 point)
    {
        least = {point.x < least.x ? point.x : least.x, point.y < least.y ? point.y : least.y};
        most = {point.x > most.x ? point.x : most.x, point.y > most.y ? point.y : most.y};
    }

    /// Returns the square of the distance from a point; 0 inside.
    double squareTo(glm::dvec2 point) const
    {
        const double dx = point.x < least.x ? least.x - point.x : point.x > most.x ? point.x - most.x : 0.0;
        const double dy = point.y < least.y ? least.y - point.y : point.y > most.y ? point.y - most.y : 0.0;
        return dx * dx + dy * dy;
    }
};

/// A binary tree over boxes that do not change, halved at the median of their middles.
/// Differs from a library's R-tree: the search asks for the true distance of each candidate as it goes and
/// drops what cannot be nearer, and it allocates nothing.
/// Source: Kay & Kajiya, *Ray tracing complex scenes*, 1986 (median cut); Roussopoulos, Kelley & Vincent,
/// *Nearest neighbor queries*, 1995 (branch and bound).
class BoxTree
{
public:
    BoxTree() = default;
    explicit BoxTree(const std::vector<PlanBox>& boxes);

    bool isEmpty() const { return _nodes.empty(); }

    /// Calls `visit(item, limit)` for items in growing distance of their branches, while they are not farther
    /// away than the square root of `limit`; `visit` returns the new limit. `limit`: squares of metres.
    template<class Visit>
    void search(glm::dvec2 point, double limit, const Visit& visit) const
    {
        struct Waiting
        {
            std::uint32_t node;
            double square;
        };
        std::array<Waiting, kDeepest> stack;
        std::size_t count = 0;
        if (!isEmpty()) stack[count++] = {0, _nodes[0].box.squareTo(point)};
        while (count > 0)
        {
            const Waiting waiting = stack[--count];
            if (waiting.square > limit) continue;
            const Node& node = _nodes[waiting.node];
            if (node.count > 0)
            {
                for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
                    limit = visit(_items[i], limit);
                continue;
            }
            const Waiting near{node.first, _nodes[node.first].box.squareTo(point)};
            const Waiting far{node.first + 1, _nodes[node.first + 1].box.squareTo(point)};
            const bool isSwapped = far.square < near.square;
            stack[count++] = isSwapped ? near : far;
            stack[count++] = isSwapped ? far : near;
        }
    }

private:
    struct Node
    {
        PlanBox box;
        std::uint32_t first = 0; ///< the first item of a leaf, or the first of two children
        std::uint32_t count = 0; ///< items of a leaf; 0: an inner node
    };

    static constexpr std::size_t kDeepest = 128;
    static constexpr std::uint32_t kLeafItems = 4;

    void build(std::uint32_t node, std::uint32_t first, std::uint32_t count,
               const std::vector<PlanBox>& boxes);

    std::vector<Node> _nodes;
    std::vector<std::uint32_t> _items;
};

} // namespace osgRoads::core
