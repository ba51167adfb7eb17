// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osgTerrainROAM/core/blocks/LevelChoice.h>

#include "CeilingSearch.h"

namespace osgTerrainROAM::core
{

namespace
{

/// Makes neighbours finer until no border of a block is off by more than the block may. Each visit can only
/// make levels finer, so it ends; blocks are visited in their order.
void refineNeighbours(const BlockErrors& errors, const std::vector<double>& allowedM,
                      std::vector<int>& levels)
{
    const BlockGrid& grid = errors.grid();
    bool isSettled = false;
    while (!isSettled)
    {
        isSettled = true;
        for (std::uint32_t block = 0; block < grid.count(); ++block)
            for (int side = 0; side < kSides; ++side)
            {
                const std::uint32_t neighbour = grid.neighbour(block, side);
                if (neighbour == kNone) continue;
                while (levels[neighbour] > levels[block] &&
                       errors.stripM(block, levels[block], side, levels[neighbour]) > allowedM[block])
                {
                    --levels[neighbour];
                    isSettled = false;
                }
            }
    }
}

/// The level at which the interpolated error is what is allowed. Below 0: so much finer the neighbours have
/// to be, because all of the error of the finest level comes from borders with coarser ones.
double continuousLevel(const BlockErrors& errors, std::uint32_t block, double allowedM)
{
    const int last = errors.levels() - 1;
    if (errors.morphedM(block, last) <= allowedM) return last;
    for (int level = last - 1; level >= 0; --level)
    {
        const double fineM = errors.morphedM(block, level), coarseM = errors.morphedM(block, level + 1);
        if (fineM <= allowedM) return level + (allowedM - fineM) / (coarseM - fineM);
    }
    return allowedM / errors.morphedM(block, 0) - 1.0;
}

/// Lowers levels until neighbours differ by at most one: the distance transform by city blocks, in two
/// sweeps.
/// Source: Rosenfeld & Pfaltz, *Sequential operations in digital picture processing*, 1966.
void limitSteps(const BlockGrid& grid, BlockLevels& levels)
{
    const auto lower = [&](std::uint32_t block, int side)
    {
        const std::uint32_t neighbour = grid.neighbour(block, side);
        if (neighbour != kNone) levels[block] = std::min(levels[block], levels[neighbour] + 1.0);
    };
    for (std::uint32_t block = 0; block < grid.count(); ++block)
    {
        lower(block, south);
        lower(block, west);
    }
    for (std::uint32_t block = grid.count(); block-- > 0;)
    {
        lower(block, north);
        lower(block, east);
    }
}

} // namespace

AllowedErrors::AllowedErrors(const BlockErrors& errors, const viewlod::ViewState& view)
{
    for (std::uint32_t block = 0; block < errors.grid().count(); ++block)
        perTolerance.push_back(allowedErrorM(errors.box(block), view));
}

BlockLevels chooseLevels(const BlockErrors& errors, const AllowedErrors& allowed, double tolerance)
{
    std::vector<int> levels;
    std::vector<double> allowedM;
    for (std::uint32_t block = 0; block < errors.grid().count(); ++block)
    {
        allowedM.push_back(allowed.perTolerance[block] * tolerance);
        int level = errors.levels() - 1;
        while (level > 0 && errors.blockM(block, level) > allowedM.back())
            --level;
        levels.push_back(level);
    }
    refineNeighbours(errors, allowedM, levels);
    return {levels.begin(), levels.end()};
}

BlockLevels chooseMorphedLevels(const BlockErrors& errors, const AllowedErrors& allowed, double tolerance)
{
    BlockLevels levels;
    for (std::uint32_t block = 0; block < errors.grid().count(); ++block)
        levels.push_back(continuousLevel(errors, block, allowed.perTolerance[block] * tolerance));
    limitSteps(errors.grid(), levels);
    for (double& level : levels)
        level = std::max(level, 0.0);
    return levels;
}

double borderLevel(const BlockGrid& grid, const BlockLevels& levels, std::uint32_t block, int side)
{
    const std::uint32_t neighbour = grid.neighbour(block, side);
    return neighbour == kNone ? levels[block] : std::max(levels[block], levels[neighbour]);
}

BlockShape shapeAt(const BlockGrid& grid, const BlockLevels& levels, std::uint32_t block)
{
    BlockShape shape{static_cast<int>(levels[block]), {}};
    for (int side = 0; side < kSides; ++side)
        shape.borders[static_cast<std::size_t>(side)] =
            static_cast<int>(borderLevel(grid, levels, block, side));
    return shape;
}

LevelsInCeiling levelsInCeiling(const BlockErrors& errors, const AllowedErrors& allowed, double target,
                                std::uint32_t most, bool morphs)
{
    const auto at = [&](double tolerance)
    {
        LevelsInCeiling found{morphs ? chooseMorphedLevels(errors, allowed, tolerance)
                                     : chooseLevels(errors, allowed, tolerance),
                              tolerance, 0};
        for (std::uint32_t block = 0; block < errors.grid().count(); ++block)
            found.triangles +=
                triangleCount(errors.grid().exponent(), shapeAt(errors.grid(), found.levels, block));
        return found;
    };
    return withinCeiling(target, most, at);
}

} // namespace osgTerrainROAM::core
