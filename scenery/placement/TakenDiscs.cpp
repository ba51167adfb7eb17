// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/TakenDiscs.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

namespace scenery
{

double leastDistanceM(const Disc& a, const Disc& b)
{
    return std::max(a.coreM + b.roomM, a.roomM + b.coreM);
}

std::int64_t TakenDiscs::cellOf(double metres)
{
    return static_cast<std::int64_t>(std::floor(metres / kCellM));
}

std::uint64_t TakenDiscs::keyOf(std::int64_t column, std::int64_t row)
{
    return (static_cast<std::uint64_t>(column) << 32U) ^ (static_cast<std::uint64_t>(row) & 0xffffffffU);
}

bool TakenDiscs::isFree(const Disc& disc) const
{
    const double reach = disc.roomM + _mostRoomM;
    for (auto row = cellOf(disc.centre.y - reach); row <= cellOf(disc.centre.y + reach); ++row)
        for (auto column = cellOf(disc.centre.x - reach); column <= cellOf(disc.centre.x + reach); ++column)
        {
            const auto found = _cells.find(keyOf(column, row));
            if (found == _cells.end()) continue;
            for (const Disc& other : found->second)
                if (glm::length(other.centre - disc.centre) < leastDistanceM(disc, other)) return false;
        }
    return true;
}

void TakenDiscs::take(const Disc& disc)
{
    _cells[keyOf(cellOf(disc.centre.x), cellOf(disc.centre.y))].push_back(disc);
    _mostRoomM = std::max(_mostRoomM, disc.roomM);
}

} // namespace scenery
