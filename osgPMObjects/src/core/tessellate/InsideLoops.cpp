// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/core/tessellate/InsideLoops.h>

#include "HalfEdges.h"

namespace osgPMObjects::core
{

namespace
{

bool isInside(std::int32_t winding, InsideRule rule)
{
    switch (rule)
    {
    case InsideRule::odd:
        return winding % 2 != 0;
    case InsideRule::nonZero:
        return winding != 0;
    case InsideRule::positive:
        return winding > 0;
    }
    return false;
}

} // namespace

std::vector<Loop> insideLoops(const NodedEdges& noded, InsideRule rule)
{
    const HalfEdges halves(noded);
    const std::vector<std::int32_t> winding = windingNumbers(halves);
    std::vector<char> isBorder(halves.size());
    for (std::uint32_t half = 0; half < halves.size(); ++half)
        isBorder[half] = isInside(winding[half], rule) && !isInside(winding[half ^ 1u], rule);
    std::vector<Loop> loops;
    for (std::uint32_t first = 0; first < halves.size(); ++first)
    {
        if (!isBorder[first]) continue;
        Loop& loop = loops.emplace_back();
        std::uint32_t half = first;
        do
        {
            isBorder[half] = 0;
            loop.push_back(halves.origin(half));
            // Go on through the same sector of the inside: skip edges that are no border, up to the first
            // that is.
            std::uint32_t behind = halves.next(half);
            while (!isBorder[behind] && behind != first)
                behind = halves.clockwise(behind);
            half = behind;
        } while (half != first);
    }
    return loops;
}

} // namespace osgPMObjects::core
