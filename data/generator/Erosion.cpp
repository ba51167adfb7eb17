// SPDX-License-Identifier: Apache-2.0
#include "Erosion.h"

#include <cmath>
#include <utility>
#include <vector>

namespace islandgen
{

namespace
{

constexpr int kSedimentPasses = 3;

float stepCells(int cell, int receiver, int side)
{
    const int apart = receiver > cell ? receiver - cell : cell - receiver;
    return apart == 1 || apart == side ? 1.0f : kDiagonal;
}

/// A cell with its way down, and what stays the same while a step is solved.
struct Reach
{
    std::int32_t cell, receiver;
    float factor; ///< K·dt·√A / distance
    float riseM;  ///< to the next cell, where slopes stand no steeper
};

/// All cells but base cells, in the order of the network.
std::vector<Reach> reachesOf(const DrainageNetwork& network, const ErosionRates& rates)
{
    std::vector<Reach> reaches;
    reaches.reserve(network.downstreamFirst.size());
    for (const std::int32_t cell : network.downstreamFirst)
    {
        const std::int32_t receiver = network.receiver[cell];
        if (receiver == cell) continue;
        // √A / distance: the cell's metres cancel.
        const float factor = rates.riverErosion[cell] * std::sqrt(network.areaCells[cell]) /
                             stepCells(cell, receiver, network.receiver.side);
        reaches.push_back({cell, receiver, factor, rates.criticalSlope[cell] * rates.cellM});
    }
    return reaches;
}

/// Asks memory for the cell that comes so many reaches later: rivers leap about the raster, and it is larger
/// than any cache.
constexpr std::size_t kReachesAhead = 16;

void fetch(const Grid<float>& grid, std::int32_t cell)
{
    __builtin_prefetch(&grid.cells[static_cast<std::size_t>(cell)]);
}

/// The height above which a cell slides: the slope of a plane through its lower neighbours in both axes, and
/// not that along one of eight directions, is critical.
/// Source: upwind solution of the eikonal equation, Sethian 1996.
float standingHeight(const Grid<float>& heightM, int cell, float riseM)
{
    const int column = cell % heightM.side;
    const int row = cell / heightM.side;
    const float alongRow = std::min(heightM.clamped(column - 1, row), heightM.clamped(column + 1, row));
    const float alongColumn = std::min(heightM.clamped(column, row - 1), heightM.clamped(column, row + 1));
    const float apart = alongRow - alongColumn;
    const float inside = 2.0f * riseM * riseM - apart * apart;
    if (inside <= riseM * riseM) return std::min(alongRow, alongColumn) + riseM;
    return 0.5f * (alongRow + alongColumn + std::sqrt(inside));
}

/// One solution of the implicit equation with the settling sediment given (metres per cell).
void solveHeights(Grid<float>& heightM, const Grid<float>& suppliedM, const std::vector<Reach>& reaches)
{
    const int side = heightM.side, count = heightM.count();
    for (std::size_t i = 0; i < reaches.size(); ++i)
    {
        if (i + kReachesAhead < reaches.size())
        {
            const std::int32_t later = reaches[i + kReachesAhead].cell;
            fetch(suppliedM, later);
            fetch(heightM, later);
            fetch(heightM, std::max(later - side, 0));
            fetch(heightM, std::min(later + side, count - 1));
        }
        const Reach& reach = reaches[i];
        const float eroded =
            (suppliedM[reach.cell] + reach.factor * heightM[reach.receiver]) / (1.0f + reach.factor);
        heightM[reach.cell] = std::min(eroded, standingHeight(heightM, reach.cell, reach.riseM));
    }
}

/// What each cell would be without rivers after this step: its height, the uplift, and the share of the
/// sediment that passes it and settles there, if the land ended as `after`.
Grid<float> suppliedHeights(const Grid<float>& before, const Grid<float>& after,
                            const std::vector<Reach>& reaches, const Grid<float>& areaCells,
                            const ErosionRates& rates)
{
    Grid<float> fromUpstreamM(before.side);
    for (std::size_t i = reaches.size(); i-- > 0;)
    {
        if (i >= kReachesAhead)
        {
            const std::int32_t later = reaches[i - kReachesAhead].cell;
            for (const Grid<float>* grid : {&std::as_const(fromUpstreamM), &before, &rates.upliftM, &after})
                fetch(*grid, later);
        }
        const Reach& reach = reaches[i];
        const float carried =
            fromUpstreamM[reach.cell] + before[reach.cell] + rates.upliftM[reach.cell] - after[reach.cell];
        fromUpstreamM[reach.receiver] += std::max(carried, 0.0f);
    }
    for (int cell = 0; cell < before.count(); ++cell)
    {
        fromUpstreamM[cell] =
            before[cell] + rates.upliftM[cell] + rates.deposition * fromUpstreamM[cell] / areaCells[cell];
    }
    return fromUpstreamM;
}

} // namespace

void erodeRivers(Grid<float>& heightM, const DrainageNetwork& network, const ErosionRates& rates)
{
    const Grid<float> before = heightM;
    for (int cell = 0; cell < before.count(); ++cell)
        heightM[cell] = before[cell] + rates.upliftM[cell];
    const Grid<float> lifted = heightM;
    heightM = before;
    const std::vector<Reach> reaches = reachesOf(network, rates);
    solveHeights(heightM, lifted, reaches);
    for (int pass = 0; pass < kSedimentPasses; ++pass)
        solveHeights(heightM, suppliedHeights(before, heightM, reaches, network.areaCells, rates), reaches);
}

namespace
{

/// Solves many tridiagonal systems side by side. Line i of system s is cell s·across + i·along.
struct LineSolver
{
    int across;
    int along;
};

/// (I − D·d²/dx²) h' = h on a block of neighbouring lines: the inner loop runs across them, in memory order.
void diffuseLines(Grid<float>& heightM, const Grid<float>& conductance, const Grid<std::uint8_t>& fixed,
                  LineSolver lines, int firstLine, int lineCount)
{
    const int n = heightM.side;
    std::vector<float> upper(static_cast<std::size_t>(n) * lineCount);
    const auto slot = [&](int i, int s) { return static_cast<std::size_t>(i) * lineCount + s; };
    const auto cellAt = [&](int i, int s) { return (firstLine + s) * lines.across + i * lines.along; };
    for (int i = 0; i < n; ++i)
    {
        for (int s = 0; s < lineCount; ++s)
        {
            const int cell = cellAt(i, s);
            const float toPrevious =
                i > 0 && !fixed[cell] ? 0.5f * (conductance[cell] + conductance[cellAt(i - 1, s)]) : 0.0f;
            const float toNext =
                i + 1 < n && !fixed[cell] ? 0.5f * (conductance[cell] + conductance[cellAt(i + 1, s)]) : 0.0f;
            const float before = i > 0 ? upper[slot(i - 1, s)] : 0.0f;
            const float heightBefore = i > 0 ? heightM[cellAt(i - 1, s)] : 0.0f;
            const float pivot = 1.0f + toPrevious + toNext - toPrevious * before;
            upper[slot(i, s)] = toNext / pivot;
            heightM[cell] = (heightM[cell] + toPrevious * heightBefore) / pivot;
        }
    }
    for (int i = n - 2; i >= 0; --i)
    {
        for (int s = 0; s < lineCount; ++s)
        {
            heightM[cellAt(i, s)] += upper[slot(i, s)] * heightM[cellAt(i + 1, s)];
        }
    }
}

constexpr int kLinesPerBlock = 32;

} // namespace

void creep(Grid<float>& heightM, const Grid<float>& creepCells2, const Grid<std::uint8_t>& isBase)
{
    const int n = heightM.side;
    for (const LineSolver lines : {LineSolver{n, 1}, LineSolver{1, n}})
    {
        for (int first = 0; first < n; first += kLinesPerBlock)
        {
            diffuseLines(heightM, creepCells2, isBase, lines, first, std::min(kLinesPerBlock, n - first));
        }
    }
}

} // namespace islandgen
