// SPDX-License-Identifier: Apache-2.0
#include "LandEvolution.h"

#include "Coast.h"
#include "DrainageNetwork.h"
#include "Erosion.h"
#include "Resample.h"
#include "SurfaceDetail.h"
#include "ValleyFloors.h"

namespace islandgen
{

namespace
{

constexpr int kCoarsestSide = 129;
constexpr float kErodibilityPerYear = 2e-5f; // of the mean rock; with m = 0.5 it has no length in it
constexpr float kWander = 0.6f;
constexpr float kShelfEdgeKm = -0.8f;
constexpr float kDeposition = 0.4f;
constexpr float kRockM = 220.0f; // wavelength of the largest variation of the rock within a bed
constexpr float kRuffle = 0.02f; // height per cell size
constexpr float kSettleYears = 2e3f;
constexpr int kSettleSteps = 3;

struct Stage
{
    int side;
    int steps;
    float stepYears;
};

Stage stageFor(int side)
{
    switch (side)
    {
    case 129:
        return {side, 80, 2e4f};
    case 257:
        return {side, 30, 2e4f};
    case 513:
        return {side, 20, 1.5e4f};
    case 1025:
        return {side, 12, 1e4f};
    default:
        return {side, 7, 6e3f};
    }
}

/// Rock is not the same everywhere: walls stand steeper here than a hundred metres on.
float rockVariation(const Grid<float>& grid, int cell, float cellM, Noise noise)
{
    const int row = cell / grid.side;
    const float u = static_cast<float>(cell - row * grid.side) * cellM / kRockM;
    const float v = static_cast<float>(row) * cellM / kRockM;
    return 1.0f + 0.35f * noise.fractal(u, v, 3, 0.6f);
}

ErosionRates ratesFor(const IslandPlan& plan, float stepYears, Noise noise)
{
    const int side = plan.inlandKm.side;
    ErosionRates rates{Grid<float>(side),
                       Grid<float>(side),
                       Grid<float>(side),
                       plan.criticalSlope,
                       kExtentKm * 1000.0f / static_cast<float>(side - 1),
                       kDeposition};
    for (int cell = 0; cell < rates.upliftM.count(); ++cell)
    {
        const float creepM = plan.diffuseKm[cell] * 1000.0f;
        const float uneven = 0.5f + noise.channel(1).at(cell);
        rates.upliftM[cell] = plan.steepnessM[cell] * kErodibilityPerYear * stepYears;
        rates.riverErosion[cell] = plan.erodibility[cell] * uneven * kErodibilityPerYear * stepYears;
        rates.creepCells2[cell] =
            kErodibilityPerYear * stepYears * creepM * creepM / (rates.cellM * rates.cellM);
        rates.criticalSlope[cell] *= rockVariation(rates.criticalSlope, cell, rates.cellM, noise);
    }
    return rates;
}

Grid<float> firstLand(const IslandPlan& plan, Noise noise)
{
    Grid<float> heightM(plan.inlandKm.side);
    for (int cell = 0; cell < heightM.count(); ++cell)
    {
        if (plan.inlandKm[cell] > 0.0f)
            heightM[cell] = 5.0f + 10.0f * noise.at(cell) + 4.0f * plan.inlandKm[cell];
    }
    return heightM;
}

/// A little unevenness at the size of a cell, so that rivers on smooth fans have reasons to turn.
void ruffle(Grid<float>& heightM, Noise noise)
{
    const float amplitudeM = kRuffle * kExtentKm * 1000.0f / static_cast<float>(heightM.side - 1);
    for (int cell = 0; cell < heightM.count(); ++cell)
        heightM[cell] += amplitudeM * (noise.at(cell) - 0.5f);
}

void runSteps(Grid<float>& heightM, const Grid<std::uint8_t>& isBase, const ErosionRates& rates, int steps,
              Noise noise)
{
    for (int step = 0; step < steps; ++step)
    {
        const auto chance = noise.channel(static_cast<std::uint64_t>(heightM.side) * 1000 + step);
        const DrainageNetwork network = routeDrainage(heightM, isBase, chance, kWander);
        erodeRivers(heightM, network, rates);
        creep(heightM, rates.creepCells2, isBase);
    }
}

/// Rivers run to the edge of the shelf, as with a low sea.
void runStage(Grid<float>& heightM, const IslandPlan& plan, const Stage& stage, Noise noise)
{
    Grid<std::uint8_t> isShelf(stage.side, 0);
    for (int cell = 0; cell < isShelf.count(); ++cell)
    {
        isShelf[cell] = plan.inlandKm[cell] <= kShelfEdgeKm;
        heightM[cell] =
            isShelf[cell] ? plan.shelfM[cell] : std::max(heightM[cell], plan.shelfM[cell] + 0.01f);
    }
    runSteps(heightM, isShelf, ratesFor(plan, stage.stepYears, noise.channel(3)), stage.steps,
             noise.channel(4));
}

/// The last, short time, with the sea at 0.
Land settle(Grid<float> heightM, const IslandPlan& plan, Noise noise)
{
    Land land{std::move(heightM), Grid<std::uint8_t>(plan.inlandKm.side)};
    land.isSea = raiseSea(land.heightM, plan, noise.channel(1));
    const ErosionRates rates = ratesFor(plan, kSettleYears, noise.channel(3));
    const DrainageNetwork network = routeDrainage(land.heightM, land.isSea, noise.channel(2), 0.0f);
    planeValleyFloors(land.heightM, network, land.isSea, rates.cellM);
    roughenSlopes(land.heightM, rates.cellM, noise.channel(4));
    runSteps(land.heightM, land.isSea, rates, kSettleSteps, noise.channel(3));
    return land;
}

} // namespace

Land evolveLand(const IslandPlan& plan, int side, Noise noise)
{
    IslandPlan levelPlan = resampled(plan, kCoarsestSide);
    Grid<float> heightM = firstLand(levelPlan, noise.channel(1));
    runStage(heightM, levelPlan, stageFor(kCoarsestSide), noise);
    for (int finer = 2 * kCoarsestSide - 1; finer <= side; finer = 2 * finer - 1)
    {
        levelPlan = resampled(plan, finer);
        heightM = resampledBent(heightM, finer, noise.channel(finer), 14.0f, 2.5f);
        ruffle(heightM, noise.channel(finer + 1));
        runStage(heightM, levelPlan, stageFor(finer), noise);
    }
    return settle(std::move(heightM), levelPlan, noise.channel(2));
}

} // namespace islandgen
