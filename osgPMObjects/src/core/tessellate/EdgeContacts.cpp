// SPDX-License-Identifier: Apache-2.0
#include "EdgeContacts.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include <osgPMObjects/core/tessellate/Orientation.h>

namespace osgPMObjects::core
{

namespace
{

struct Box
{
    glm::dvec2 low, high;
};

Box boxOf(std::span<const glm::dvec2> points, const EdgeEnds& edge)
{
    return {glm::min(points[edge[0]], points[edge[1]]), glm::max(points[edge[0]], points[edge[1]])};
}

/// Tells whether a point on the line of an edge lies between its ends.
bool isBetween(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p)
{
    const glm::dvec2 low = glm::min(a, b), high = glm::max(a, b);
    return p != a && p != b && p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
}

} // namespace

EdgeContact contactOf(std::span<const glm::dvec2> points, const EdgeEnds& first, const EdgeEnds& second)
{
    const glm::dvec2 &a = points[first[0]], &b = points[first[1]];
    const glm::dvec2 &c = points[second[0]], &d = points[second[1]];
    const double sideC = orientation(a, b, c), sideD = orientation(a, b, d);
    if ((sideC > 0.0 && sideD > 0.0) || (sideC < 0.0 && sideD < 0.0)) return {};
    const double sideA = orientation(c, d, a), sideB = orientation(c, d, b);
    EdgeContact contact;
    contact.endInFirst = {sideC == 0.0 && isBetween(a, b, c), sideD == 0.0 && isBetween(a, b, d)};
    contact.endInSecond = {sideA == 0.0 && isBetween(c, d, a), sideB == 0.0 && isBetween(c, d, b)};
    contact.crosses = sideC != 0.0 && sideD != 0.0 && sideA != 0.0 && sideB != 0.0 &&
                      (sideC > 0.0) != (sideD > 0.0) && (sideA > 0.0) != (sideB > 0.0);
    return contact;
}

void forEachContact(std::span<const glm::dvec2> points, std::span<const EdgeEnds> edges,
                    const std::function<void(std::uint32_t, std::uint32_t, const EdgeContact&)>& found)
{
    std::vector<Box> boxes;
    boxes.reserve(edges.size());
    for (const EdgeEnds& edge : edges)
        boxes.push_back(boxOf(points, edge));
    std::vector<std::uint32_t> byX(edges.size());
    std::iota(byX.begin(), byX.end(), 0u);
    std::sort(byX.begin(), byX.end(),
              [&](std::uint32_t i, std::uint32_t j)
              { return std::pair(boxes[i].low.x, i) < std::pair(boxes[j].low.x, j); });
    for (std::size_t i = 0; i < byX.size(); ++i)
    {
        const Box& box = boxes[byX[i]];
        for (std::size_t j = i + 1; j < byX.size() && boxes[byX[j]].low.x <= box.high.x; ++j)
        {
            const Box& other = boxes[byX[j]];
            if (other.low.y > box.high.y || other.high.y < box.low.y) continue;
            const EdgeContact contact = contactOf(points, edges[byX[i]], edges[byX[j]]);
            if (contact.exists()) found(byX[i], byX[j], contact);
        }
    }
}

} // namespace osgPMObjects::core
