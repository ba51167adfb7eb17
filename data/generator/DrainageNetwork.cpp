// SPDX-License-Identifier: Apache-2.0
#include "DrainageNetwork.h"

#include "HeightQueue.h"

namespace islandgen
{

namespace
{

constexpr int kFloodBuckets = 16384;

std::int32_t chosenReceiver(const Grid<float>& heightM, int column, int row, Noise chance, float wander)
{
    const int cell = heightM.index(column, row);
    std::int32_t best = cell;
    float bestSlope = 0.0f;
    for (int k = 0; k < 8; ++k)
    {
        const int c = column + kNeighbours[k].column;
        const int r = row + kNeighbours[k].row;
        if (c < 0 || r < 0 || c >= heightM.side || r >= heightM.side) continue;
        const float drop = heightM[cell] - heightM.at(c, r);
        if (drop <= 0.0f) continue;
        const float factor = 1.0f + wander * (2.0f * chance.at(cell * 8 + k) - 1.0f);
        const float slope = drop / kNeighbours[k].distance * factor;
        if (slope > bestSlope)
        {
            bestSlope = slope;
            best = heightM.index(c, r);
        }
    }
    return best;
}

} // namespace

std::vector<std::int32_t> fillDepressions(Grid<float>& heightM, const Grid<std::uint8_t>& isBase, float riseM)
{
    const auto [lowest, highest] = std::minmax_element(heightM.cells.begin(), heightM.cells.end());
    HeightQueue queue(*lowest, *highest, kFloodBuckets);
    Grid<std::uint8_t> reached(heightM.side, 0);
    for (int cell = 0; cell < heightM.count(); ++cell)
    {
        if (!isBase[cell]) continue;
        reached[cell] = 1;
        queue.push({heightM[cell], cell});
    }
    std::vector<std::int32_t> order;
    order.reserve(heightM.cells.size());
    HeightQueue::Entry entry{};
    while (queue.pop(entry))
    {
        order.push_back(entry.cell);
        const int column = entry.cell % heightM.side;
        const int row = entry.cell / heightM.side;
        for (const NeighbourStep& step : kNeighbours)
        {
            const int c = column + step.column;
            const int r = row + step.row;
            if (c < 0 || r < 0 || c >= heightM.side || r >= heightM.side) continue;
            const int neighbour = heightM.index(c, r);
            if (reached[neighbour]) continue;
            reached[neighbour] = 1;
            heightM[neighbour] = std::max(heightM[neighbour], entry.heightM + riseM);
            queue.push({heightM[neighbour], neighbour});
        }
    }
    return order;
}

DrainageNetwork routeDrainage(Grid<float>& heightM, const Grid<std::uint8_t>& isBase, Noise chance,
                              float wander)
{
    DrainageNetwork network{Grid<std::int32_t>(heightM.side), Grid<float>(heightM.side, 1.0f),
                            fillDepressions(heightM, isBase)};
    for (int row = 0; row < heightM.side; ++row)
    {
        for (int column = 0; column < heightM.side; ++column)
        {
            const int cell = heightM.index(column, row);
            network.receiver[cell] =
                isBase[cell] ? cell : chosenReceiver(heightM, column, row, chance, wander);
        }
    }
    for (std::size_t i = network.downstreamFirst.size(); i-- > 0;)
    {
        const std::int32_t cell = network.downstreamFirst[i];
        const std::int32_t receiver = network.receiver[cell];
        if (receiver != cell) network.areaCells[receiver] += network.areaCells[cell];
    }
    return network;
}

bool drainsEverywhere(const DrainageNetwork& network, const Grid<std::uint8_t>& isBase)
{
    if (network.downstreamFirst.size() != isBase.cells.size()) return false;
    Grid<std::uint8_t> drained(isBase.side, 0);
    for (const std::int32_t cell : network.downstreamFirst)
    {
        drained[cell] = isBase[cell] || (network.receiver[cell] != cell && drained[network.receiver[cell]]);
        if (!drained[cell]) return false;
    }
    return true;
}

} // namespace islandgen
