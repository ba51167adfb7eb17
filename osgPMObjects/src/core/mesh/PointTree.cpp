// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>

#include <osgPMObjects/core/mesh/PointTree.h>

namespace osgPMObjects::core
{

PointTree::PointTree(std::span<const glm::dvec3> points) : _points(points), _order(points.size())
{
    std::iota(_order.begin(), _order.end(), 0u);
    _nodes.reserve(points.size() / 2 + 1);
    if (!points.empty()) build(0, static_cast<std::uint32_t>(points.size()));
}

/// Builds the node of a range of the order, and those below it.
void PointTree::build(std::uint32_t first, std::uint32_t last)
{
    const std::size_t number = _nodes.size();
    Node node;
    for (std::uint32_t i = first; i < last; ++i)
        node.box.add(_points[_order[i]]);
    node.first = first;
    node.left = last - first;
    _nodes.push_back(node);
    if (last - first <= kLeafSize) return;
    const glm::dvec3 size = node.box.high - node.box.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(_order.begin() + first, _order.begin() + middle, _order.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b)
                     {
                         const double x = _points[a][axis], y = _points[b][axis];
                         return x != y ? x < y : a < b;
                     });
    build(first, middle);
    _nodes[number].second = static_cast<std::uint32_t>(_nodes.size());
    build(middle, last);
}

} // namespace osgPMObjects::core
