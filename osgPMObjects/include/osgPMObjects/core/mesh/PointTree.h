// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Extent.h>

namespace osgPMObjects::core
{

/// A bounding-volume tree of numbered points, for searches by any test of boxes. The effort of a search
/// follows from what it finds, not from how the points are spread, unlike that of PointGrid.
/// Memory: some 20 B a point besides the points, which are referenced. Threads: one that takes points; any
/// number that only visit.
/// Cost: building n log n, 0.1 s for half a million.
/// Source: Bentley, *Multidimensional binary search trees used for associative searching*, 1975. Differs:
/// bounding boxes, leaves of several points.
class PointTree
{
public:
    explicit PointTree(std::span<const glm::dvec3> points);

    /// Calls `visit(number)` for all points of leaves whose boxes, and those above them, pass `touches(box)`.
    /// `work` is the number of boxes and points that may still be looked at; it is reduced, and the search
    /// ends when it reaches 0.
    template<class Touches, class Visit>
    void visit(const Touches& touches, std::uint64_t& work, const Visit& visit) const
    {
        if (!_nodes.empty()) visitFrom(0, touches, work, visit);
    }

    /// Does the same and takes the points out of the tree for which `takes(number)` returns true.
    template<class Touches, class Takes>
    void extract(const Touches& touches, std::uint64_t& work, const Takes& takes)
    {
        if (!_nodes.empty()) takeFrom(0, touches, work, takes);
    }

    std::uint32_t nodeCount() const { return static_cast<std::uint32_t>(_nodes.size()); }

private:
    static constexpr std::uint32_t kLeafSize = 8;

    struct Node
    {
        Extent box;
        std::uint32_t first = 0;  ///< leaf: in _order; else 0
        std::uint32_t second = 0; ///< the second child; the first one follows its parent; leaf: 0
        std::uint32_t left = 0;   ///< number of points that are still in the tree
    };

    void build(std::uint32_t first, std::uint32_t last);

    /// Whether a node is to be searched; counts it and the points of a leaf as work.
    template<class Touches>
    bool enters(const Node& node, const Touches& touches, std::uint64_t& work) const
    {
        if (node.left == 0 || work == 0) return false;
        --work;
        return touches(node.box);
    }

    template<class Touches, class Visit>
    void visitFrom(std::uint32_t number, const Touches& touches, std::uint64_t& work,
                   const Visit& visit) const
    {
        const Node& node = _nodes[number];
        if (!enters(node, touches, work)) return;
        if (node.second != 0)
        {
            visitFrom(number + 1, touches, work, visit);
            return visitFrom(node.second, touches, work, visit);
        }
        for (std::uint32_t i = node.first; i < node.first + node.left && work > 0; ++i, --work)
            visit(_order[i]);
    }

    template<class Touches, class Takes>
    void takeFrom(std::uint32_t number, const Touches& touches, std::uint64_t& work, const Takes& takes)
    {
        Node& node = _nodes[number];
        if (!enters(node, touches, work)) return;
        if (node.second != 0)
        {
            takeFrom(number + 1, touches, work, takes);
            takeFrom(node.second, touches, work, takes);
            node.left = _nodes[number + 1].left + _nodes[node.second].left;
            return;
        }
        for (std::uint32_t i = node.first; i < node.first + node.left && work > 0; --work)
            if (takes(_order[i]))
                std::swap(_order[i], _order[node.first + --node.left]);
            else
                ++i;
    }

    std::span<const glm::dvec3> _points;
    std::vector<std::uint32_t> _order; ///< point numbers, leaf by leaf
    std::vector<Node> _nodes;
};

} // namespace osgPMObjects::core
