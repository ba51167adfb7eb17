// SPDX-License-Identifier: Apache-2.0
// Source: Kay & Kajiya, *Ray tracing complex scenes*, 1986 (median cut).
#include <algorithm>
#include <numeric>

#include <osgRoads/core/query/BoxTree.h>

namespace osgRoads::core
{

BoxTree::BoxTree(const std::vector<PlanBox>& boxes) : _items(boxes.size())
{
    if (boxes.empty()) return;
    std::iota(_items.begin(), _items.end(), 0u);
    _nodes.reserve(boxes.size());
    _nodes.emplace_back();
    build(0, 0, static_cast<std::uint32_t>(boxes.size()), boxes);
}

void BoxTree::build(std::uint32_t node, std::uint32_t first, std::uint32_t count,
                    const std::vector<PlanBox>& boxes)
{
    PlanBox box, middles;
    for (std::uint32_t i = first; i < first + count; ++i)
    {
        const PlanBox& item = boxes[_items[i]];
        box.include(item.least);
        box.include(item.most);
        middles.include(0.5 * (item.least + item.most));
    }
    _nodes[node].box = box;
    if (count <= kLeafItems)
    {
        _nodes[node].first = first;
        _nodes[node].count = count;
        return;
    }
    const glm::dvec2 size = middles.most - middles.least;
    const bool isTall = size.y > size.x;
    const auto middle = [&](std::uint32_t item)
    { return isTall ? boxes[item].least.y + boxes[item].most.y : boxes[item].least.x + boxes[item].most.x; };
    const std::uint32_t half = count / 2;
    const auto begin = _items.begin() + first;
    std::nth_element(begin, begin + half, begin + count,
                     [&](std::uint32_t a, std::uint32_t b)
                     {
                         const double left = middle(a), right = middle(b);
                         return left < right || (left == right && a < b);
                     });
    const auto child = static_cast<std::uint32_t>(_nodes.size());
    _nodes[node].first = child;
    _nodes.resize(_nodes.size() + 2);
    build(child, first, half, boxes);
    build(child + 1, first + half, count - half, boxes);
}

} // namespace osgRoads::core
