// SPDX-License-Identifier: Apache-2.0
#include "Coast.h"

#include <cmath>

#include "Raster.h"

namespace islandgen
{

namespace
{

constexpr float kDeltaShare = 5e-3f; ///< metres of sediment per metre of steepness
constexpr float kBeachM = 90.0f;     ///< width of the strip that waves flatten
constexpr float kLowShoreM = 14.0f;  ///< shores lower than this become beaches

int cellsFor(float metres, float cellM)
{
    return std::max(1, static_cast<int>(std::lround(metres / cellM)));
}

/// Waves: a shore of low land follows the mean of a wide neighbourhood, a high one keeps its shape.
void smoothShore(Grid<std::uint8_t>& isSea, const Grid<float>& heightM, float cellM, Noise noise)
{
    Grid<float> sea(isSea.side);
    Grid<float> land(isSea.side);
    for (int cell = 0; cell < isSea.count(); ++cell)
    {
        sea[cell] = isSea[cell];
        land[cell] = std::min(std::max(heightM[cell], 0.0f), 80.0f);
    }
    const Grid<float> wide = blurred(sea, cellsFor(110.0f, cellM));
    const Grid<float> narrow = blurred(sea, cellsFor(55.0f, cellM));
    const Grid<float> relief = blurred(land, cellsFor(150.0f, cellM));
    for (int row = 1; row + 1 < isSea.side; ++row)
    {
        for (int column = 1; column + 1 < isSea.side; ++column)
        {
            const int cell = isSea.index(column, row);
            if (wide[cell] < 0.02f || wide[cell] > 0.98f) continue;
            const float rock = std::clamp((relief[cell] - 4.0f) / 14.0f, 0.0f, 1.0f);
            const float u = static_cast<float>(column) * cellM / 400.0f;
            const float v = static_cast<float>(row) * cellM / 400.0f;
            const float attack = 0.5f - 0.24f * rock + (0.08f + 0.14f * rock) * noise.fractal(u, v, 5, 0.65f);
            isSea[cell] = wide[cell] + rock * (narrow[cell] - wide[cell]) > attack;
        }
    }
}

/// Drops pieces of sea that have no way to the open sea; islets stay.
void keepOpenSea(Grid<std::uint8_t>& isSea)
{
    Grid<std::uint8_t> open(isSea.side, 0);
    std::vector<int> stack{0};
    open[0] = 1;
    while (!stack.empty())
    {
        const int cell = stack.back();
        stack.pop_back();
        for (int k = 0; k < 8; k += 2)
        {
            const int c = cell % isSea.side + kNeighbours[k].column;
            const int r = cell / isSea.side + kNeighbours[k].row;
            if (c < 0 || r < 0 || c >= isSea.side || r >= isSea.side) continue;
            const int neighbour = isSea.index(c, r);
            if (open[neighbour] || !isSea[neighbour]) continue;
            open[neighbour] = 1;
            stack.push_back(neighbour);
        }
    }
    isSea = open;
}

/// Sea is 0; land that rose from it slopes up gently; low shores become beaches.
void levelShore(Grid<float>& heightM, const Grid<std::uint8_t>& isSea, float cellM)
{
    const Grid<float> inlandCells = distanceTo(isSea);
    for (int cell = 0; cell < heightM.count(); ++cell)
    {
        const float inlandM = inlandCells[cell] * cellM;
        if (isSea[cell])
        {
            heightM[cell] = 0.0f;
            continue;
        }
        const float strandM = 0.4f + 0.012f * std::min(inlandM, kBeachM) + 0.0015f * inlandM;
        heightM[cell] = std::max(heightM[cell], strandM);
        if (inlandM >= kBeachM || heightM[cell] >= kLowShoreM) continue;
        const float low = 1.0f - heightM[cell] / kLowShoreM;
        const float near = 1.0f - inlandM / kBeachM;
        heightM[cell] += (strandM - heightM[cell]) * near * std::sqrt(low);
    }
}

} // namespace

Grid<std::uint8_t> raiseSea(Grid<float>& heightM, const IslandPlan& plan, Noise noise)
{
    const float cellM = kExtentKm * 1000.0f / static_cast<float>(heightM.side - 1);
    Grid<std::uint8_t> isSea(heightM.side);
    Grid<float> flooded = heightM;
    Grid<float> sedimentM(heightM.side);
    for (int cell = 0; cell < heightM.count(); ++cell)
    {
        isSea[cell] = heightM[cell] <= 0.0f;
        flooded[cell] = std::max(heightM[cell], 0.0f);
        sedimentM[cell] = kDeltaShare * plan.steepnessM[cell];
    }
    keepOpenSea(isSea);
    const DrainageNetwork network = routeDrainage(flooded, isSea, noise, 0.0f);
    buildDeltas(isSea, heightM, network, sedimentM, noise.channel(1));
    smoothShore(isSea, heightM, cellM, noise.channel(2));
    keepOpenSea(isSea);
    levelShore(heightM, isSea, cellM);
    return isSea;
}

} // namespace islandgen
