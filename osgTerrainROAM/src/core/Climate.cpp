// SPDX-License-Identifier: Apache-2.0
// The fixed points are round numbers of the order of the zonal means in Körner & Paulsen, "A world-wide study
// of high altitude treeline temperatures" (2004); they are no fit.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <osgTerrainROAM/core/Climate.h>

namespace osgTerrainROAM::core
{

namespace
{

struct LinePoint
{
    double latitudeDeg;
    double heightM;
};

constexpr std::array<LinePoint, 7> kTreeLine{{{0.0, 3700.0},
                                              {30.0, 3900.0},
                                              {36.0, 2550.0},
                                              {47.0, 2050.0},
                                              {60.0, 1050.0},
                                              {70.0, 350.0},
                                              {80.0, 0.0}}};
constexpr std::array<LinePoint, 7> kSnowLine{{{0.0, 4700.0},
                                              {30.0, 4800.0},
                                              {36.0, 3250.0},
                                              {47.0, 2550.0},
                                              {60.0, 1300.0},
                                              {70.0, 600.0},
                                              {85.0, 0.0}}};

struct DryLand
{
    double latitudeDeg, longitudeDeg; ///< centre
    double halfHeightDeg, halfWidthDeg;
    double aridity;
};

constexpr std::array<DryLand, 11> kDryLands{{
    {23.0, 8.0, 10.0, 26.0, 1.0},   // Sahara
    {25.0, 45.0, 10.0, 14.0, 1.0},  // Arabia
    {37.0, 60.0, 10.0, 12.0, 0.85}, // Iran, Turkestan
    {42.0, 95.0, 8.0, 20.0, 0.9},   // Tarim, Gobi
    {27.0, 70.0, 5.0, 6.0, 0.85},   // Thar
    {37.5, -112.0, 7.5, 7.0, 0.9},  // Great Basin, Colorado Plateau, Mojave, Sonora
    {-25.0, -69.5, 10.5, 3.0, 1.0}, // Atacama, dry Andes
    {-43.5, -68.0, 7.5, 4.0, 0.75}, // eastern Patagonia
    {-24.0, 18.0, 7.0, 7.0, 0.85},  // Namib, Kalahari
    {-25.0, 130.0, 8.0, 14.0, 0.9}, // inner Australia
    {8.0, 47.0, 7.0, 5.0, 0.8},     // Horn of Africa
}};
constexpr double kHumid = 0.12;

double interpolated(std::span<const LinePoint> line, double latitudeDeg)
{
    if (latitudeDeg <= line.front().latitudeDeg) return line.front().heightM;
    for (std::size_t i = 1; i < line.size(); ++i)
    {
        if (latitudeDeg > line[i].latitudeDeg) continue;
        const double t =
            (latitudeDeg - line[i - 1].latitudeDeg) / (line[i].latitudeDeg - line[i - 1].latitudeDeg);
        return std::lerp(line[i - 1].heightM, line[i].heightM, t);
    }
    return line.back().heightM;
}

double aridityAt(double latitudeDeg, double longitudeDeg)
{
    double aridity = kHumid;
    for (const DryLand& land : kDryLands)
    {
        const double x = std::remainder(longitudeDeg - land.longitudeDeg, 360.0) / land.halfWidthDeg;
        const double y = (latitudeDeg - land.latitudeDeg) / land.halfHeightDeg;
        // Full inside three quarters of the ellipse, humid from one and a quarter on.
        const double share = std::clamp((1.25 - std::hypot(x, y)) / 0.5, 0.0, 1.0);
        aridity = std::max(aridity, std::lerp(kHumid, land.aridity, share));
    }
    return aridity;
}

} // namespace

Climate climateAt(double latitudeDeg, double longitudeDeg)
{
    const double south = std::clamp((-latitudeDeg - 38.0) / 4.0, 0.0, 1.0);
    const double lowered = 1.0 - 0.25 * south;
    Climate climate;
    climate.latitudeDeg = latitudeDeg;
    climate.aridity = aridityAt(latitudeDeg, longitudeDeg);
    const double dry = std::clamp((climate.aridity - 0.3) / 0.7, 0.0, 1.0);
    climate.treeLineM = lowered * interpolated(kTreeLine, std::abs(latitudeDeg));
    climate.snowLineM = lowered * interpolated(kSnowLine, std::abs(latitudeDeg)) + 700.0 * dry;
    return climate;
}

Climate climateOf(const PlacedTile& tile, const LandParameters& land)
{
    Climate climate = climateAt(47.0, 8.0);
    if (tile.field().net)
    {
        const GeodeticNet& net = *tile.field().net;
        const GeodeticNet::Node& centre =
            net.node(std::min(tile.field().columns / 2 / net.step, net.nodesPerSide - 1),
                     std::min(tile.field().rows / 2 / net.step, net.nodesPerSide - 1));
        climate = climateAt(centre.latitudeDeg, centre.longitudeDeg);
    }
    climate.aridity = land.aridity.value_or(climate.aridity);
    climate.treeLineM = land.treeLineM.value_or(climate.treeLineM);
    climate.snowLineM = land.snowLineM.value_or(climate.snowLineM);
    climate.water = land.water;
    climate.seaLevelM = land.seaLevelM.value_or(climate.seaLevelM);
    return climate;
}

foundation::ContentMark markOfClimate(const Climate& climate)
{
    foundation::ContentMark mark;
    mark.add(std::vector<double>{climate.aridity, climate.treeLineM, climate.snowLineM, climate.seaLevelM,
                                 climate.latitudeDeg});
    return mark.addWord(static_cast<std::uint64_t>(climate.water));
}

} // namespace osgTerrainROAM::core
