// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/RoadGround.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <osgRoads/core/place/RoadBed.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/query/Stations.h>

#include "scenery/roads/SceneDatum.h"
#include "scenery/roads/TornRoads.h"

namespace scenery
{

namespace
{

using osgRoads::core::Road;
using osgRoads::core::RoadNetwork;

constexpr double kMarginM = 600.0;
constexpr int kMostSamples = 1000; ///< along a side
constexpr double kFinestSampleM = 2.0,
                 kLongestM = 3e5; ///< of samples beside roads: so fine up to that length

/// Heights with weights on a grid; a level of the pyramid.
struct Level
{
    int columns = 0, rows = 0;
    std::vector<float> heights, weights;

    Level(int wide, int high)
        : columns(wide),
          rows(high),
          heights(static_cast<std::size_t>(wide) * high),
          weights(static_cast<std::size_t>(wide) * high)
    {
    }
    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(std::clamp(row, 0, rows - 1)) * columns +
               std::clamp(column, 0, columns - 1);
    }
};

/// Pull: the next coarser level holds the weighted means of four.
Level coarser(const Level& fine)
{
    Level coarse((fine.columns + 1) / 2, (fine.rows + 1) / 2);
    for (int row = 0; row < fine.rows; ++row)
        for (int column = 0; column < fine.columns; ++column)
        {
            const std::size_t from = fine.index(column, row), to = coarse.index(column / 2, row / 2);
            coarse.heights[to] += fine.weights[from] * fine.heights[from];
            coarse.weights[to] += fine.weights[from];
        }
    for (std::size_t i = 0; i < coarse.heights.size(); ++i)
        if (coarse.weights[i] > 0.0f)
        {
            coarse.heights[i] /= coarse.weights[i];
            coarse.weights[i] = std::min(coarse.weights[i], 1.0f);
        }
    return coarse;
}

/// Push: where a level knows too little, the smooth interpolation of the coarser one fills it.
void push(const Level& coarse, Level& fine)
{
    for (int row = 0; row < fine.rows; ++row)
        for (int column = 0; column < fine.columns; ++column)
        {
            const int c = (column - 1) >> 1, r = (row - 1) >> 1;
            const float u = column % 2 ? 0.25f : 0.75f, v = row % 2 ? 0.25f : 0.75f;
            const auto height = [&](int dc, int dr) { return coarse.heights[coarse.index(c + dc, r + dr)]; };
            const float guess = std::lerp(std::lerp(height(0, 0), height(1, 0), u),
                                          std::lerp(height(0, 1), height(1, 1), u), v);
            const std::size_t i = fine.index(column, row);
            fine.heights[i] = std::lerp(guess, fine.heights[i], fine.weights[i]);
        }
}

void fill(Level& level)
{
    if (level.columns <= 2 || level.rows <= 2) return;
    Level coarse = coarser(level);
    fill(coarse);
    push(coarse, level);
}

/// Adds the heights beside a road, but for its bridges and tunnels. A sample farther out than the verge, so
/// that the two sides of a narrow bank do not meet in one.
void addRoad(const RoadNetwork& network, const TornRoads& torn, int index, const glm::dvec2& corner,
             double spacingM, Level& sums)
{
    const Road& road = network.roads[static_cast<std::size_t>(index)];
    const osgRoads::core::RoadBed bed;
    const double outM = bed.vergeM + 0.5 * spacingM;
    for (const double s : osgRoads::core::evenStations(road.length, 0.5 * spacingM))
    {
        if (osgRoads::core::structureAt(road, s) || torn.at(index, s)) continue;
        const auto lanes = osgRoads::core::extentAt(road, s);
        const auto frame = osgRoads::core::frameAt(road, s);
        for (const double side : {-1.0, 1.0})
        {
            const double t = side < 0.0 ? lanes.rightT : lanes.leftT;
            const glm::dvec2 beside = frame.moved({t, osgRoads::core::surfaceHeight(road, s, t)}, side * outM,
                                                  bed.vergeM * bed.vergeFall);
            const glm::dvec3 place = frame.pointAt(beside.x, beside.y);
            const glm::dvec2 grid = (glm::dvec2(place) - corner) / spacingM;
            const std::size_t at =
                sums.index(static_cast<int>(std::lround(grid.x)), static_cast<int>(std::lround(grid.y)));
            sums.heights[at] += static_cast<float>(place.z);
            sums.weights[at] += 1.0f;
        }
    }
}

osgTerrainROAM::core::HeightField fieldOf(const RoadNetwork& network, const TornRoads& torn,
                                          const PlanExtent& extent, glm::dvec2& corner)
{
    const glm::dvec2 size = extent.high - extent.low + 2.0 * kMarginM;
    osgTerrainROAM::core::HeightField field;
    field.spacingEastM = field.spacingNorthM =
        std::exp2(std::ceil(std::log2(std::max(kLeastSpacingM, std::max(size.x, size.y) / kMostSamples))));
    corner = glm::floor((extent.low - kMarginM) / field.spacingEastM) * field.spacingEastM;
    const glm::ivec2 samples(glm::ceil((extent.high + kMarginM - corner) / field.spacingEastM) + 1.0);
    Level level(samples.x, samples.y);
    for (int i = 0; i < static_cast<int>(network.roads.size()); ++i)
        if (network.roads[static_cast<std::size_t>(i)].isUsable)
            addRoad(network, torn, i, corner, field.spacingEastM, level);
    for (std::size_t i = 0; i < level.heights.size(); ++i)
        if (level.weights[i] > 0.0f)
        {
            level.heights[i] /= level.weights[i];
            level.weights[i] = 1.0f;
        }
    fill(level);
    field.columns = level.columns;
    field.rows = level.rows;
    field.heightsM = std::move(level.heights);
    return field;
}

} // namespace

double roadSampleM(const RoadNetwork& network)
{
    const double lengthM = network.usableLengthM();
    double sampleM = kFinestSampleM;
    while (lengthM > kLongestM * sampleM / kFinestSampleM)
        sampleM *= 2.0;
    return sampleM;
}

foundation::Result<RoadGround> makeRoadGround(const std::filesystem::path& file)
{
    auto read = readRoads(file);
    if (!read) return read.error();
    const auto& network = read->network;
    const PlanExtent extent = extentOf(*network);
    RoadGround ground;
    const TornRoads torn(*network);
    ground.field = fieldOf(*network, torn, extent, ground.cornerM);
    ground.field.name = file.string();
    ground.roadSampleM = roadSampleM(*network);
    const auto map = PlanMap::create(
        extent.low, extent.high,
        [corner = ground.cornerM](const glm::dvec2& plan, double heightM) -> foundation::Result<glm::dvec3>
        { return glm::dvec3(plan - corner, heightM); });
    if (!map) return map.error();
    ground.roads = {
        std::make_shared<osgRoads::core::PlacedNetwork>(network, std::make_shared<SceneDatum>(*map)),
        std::move(read->notes), file.string()};
    return ground;
}

} // namespace scenery
