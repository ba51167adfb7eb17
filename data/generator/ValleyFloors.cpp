// SPDX-License-Identifier: Apache-2.0
#include "ValleyFloors.h"

#include <cmath>

namespace islandgen
{

namespace
{

constexpr float kHalfWidthM = 17.0f;  ///< of the floor of a river that drains 1 km²
constexpr float kFloorSlope = 0.015f; ///< towards the river
constexpr float kRiverKm2 = 0.3f;     ///< smaller streams have no floor

void planeAround(Grid<float>& heightM, int cell, float halfWidthCells, float cellM)
{
    const int column = cell % heightM.side;
    const int row = cell / heightM.side;
    const int reach = static_cast<int>(halfWidthCells);
    for (int r = std::max(row - reach, 0); r <= std::min(row + reach, heightM.side - 1); ++r)
    {
        for (int c = std::max(column - reach, 0); c <= std::min(column + reach, heightM.side - 1); ++c)
        {
            const auto d2 = static_cast<float>((c - column) * (c - column) + (r - row) * (r - row));
            if (d2 > halfWidthCells * halfWidthCells) continue;
            const float floorM = heightM[cell] + kFloorSlope * cellM * std::sqrt(d2);
            heightM.at(c, r) = std::min(heightM.at(c, r), floorM);
        }
    }
}

} // namespace

void planeValleyFloors(Grid<float>& heightM, const DrainageNetwork& network, const Grid<std::uint8_t>& isSea,
                       float cellM)
{
    // From the sources down: a floor never undercuts the river upstream of it.
    for (std::size_t i = network.downstreamFirst.size(); i-- > 0;)
    {
        const std::int32_t cell = network.downstreamFirst[i];
        const float areaKm2 = network.areaCells[cell] * cellM * cellM * 1e-6f;
        if (isSea[cell] || areaKm2 < kRiverKm2) continue;
        planeAround(heightM, cell, kHalfWidthM * std::sqrt(areaKm2) / cellM, cellM);
    }
}

} // namespace islandgen
