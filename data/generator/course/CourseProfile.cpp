// SPDX-License-Identifier: Apache-2.0
#include "CourseProfile.h"

#include <algorithm>
#include <cmath>

namespace islandgen
{

namespace
{

constexpr double kLowestRoadM = 2.5;
constexpr double kPieceM = 40.0;
constexpr int kMostPasses = 2000;

/// Mean over 2·`radius`+1 values around each; the values are a ring.
std::vector<double> meansAround(const std::vector<double>& ring, std::size_t radius)
{
    const std::size_t count = ring.size();
    std::vector<double> means(count);
    double sum = 0.0;
    for (std::size_t i = 0; i <= 2 * radius; ++i)
        sum += ring[(i + count - radius) % count];
    for (std::size_t i = 0; i < count; ++i)
    {
        means[i] = sum / static_cast<double>(2 * radius + 1);
        sum += ring[(i + radius + 1) % count] - ring[(i + count - radius) % count];
    }
    return means;
}

/// Moves neighbours towards each other until no grade is too steep.
void limitGrades(std::vector<double>& ring, double stepM)
{
    const double mostM = 0.98 * kSteepestGrade * stepM;
    for (int pass = 0, changed = 1; changed && pass < kMostPasses; ++pass)
    {
        changed = 0;
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
            double& here = ring[i];
            double& next = ring[(i + 1) % ring.size()];
            const double excessM = std::abs(next - here) - mostM;
            if (excessM < 1e-6) continue;
            const double moveM = std::copysign(0.5 * excessM, next - here);
            here += moveM;
            next -= moveM;
            changed = 1;
        }
    }
}

} // namespace

double groundAt(const Terrain& terrain, const glm::dvec2& place)
{
    const double middle = 0.5 * (terrain.heightM.side - 1), cellM = terrain.cellM;
    const double x = place.x / cellM + middle, y = place.y / cellM + middle;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    const double u = x - column, v = y - row;
    const auto height = [&](int c, int r) { return static_cast<double>(terrain.heightM.clamped(c, r)); };
    return (1.0 - v) * ((1.0 - u) * height(column, row) + u * height(column + 1, row)) +
           v * ((1.0 - u) * height(column, row + 1) + u * height(column + 1, row + 1));
}

CourseHeights courseHeights(const Terrain& terrain, const Alignment& alignment, double stepM, double smoothM)
{
    CourseHeights heights;
    const auto count = static_cast<std::size_t>(std::lround(alignment.lengthM / stepM));
    heights.stepM = alignment.lengthM / static_cast<double>(count);
    const auto line = alignment.line();
    for (std::size_t i = 0; i < count; ++i)
        heights.groundM.push_back(
            groundAt(terrain, line.at(heights.stepM * static_cast<double>(i)).position));
    const auto radius = static_cast<std::size_t>(std::max(1.0, std::round(0.5 * smoothM / heights.stepM)));
    heights.roadM = heights.groundM;
    for (int pass = 0; pass < 3; ++pass)
        heights.roadM = meansAround(heights.roadM, radius);
    limitGrades(heights.roadM, heights.stepM);
    for (double& heightM : heights.roadM)
        heightM = std::max(heightM, kLowestRoadM);
    return heights;
}

osgRoads::core::CubicProfile profileOf(const CourseHeights& heights, double beyondM)
{
    const std::size_t count = heights.roadM.size();
    const double lengthM = heights.stepM * static_cast<double>(count);
    const auto pieces = static_cast<std::size_t>(std::lround(lengthM / kPieceM));
    const double pieceM = lengthM / static_cast<double>(pieces);
    std::vector<double> knots(pieces);
    for (std::size_t i = 0; i < pieces; ++i)
    {
        const double place = static_cast<double>(i) * pieceM / heights.stepM;
        const auto index = static_cast<std::size_t>(place);
        const double share = place - static_cast<double>(index);
        knots[i] = (1.0 - share) * heights.roadM[index % count] + share * heights.roadM[(index + 1) % count];
    }
    const auto knot = [&](std::size_t i) { return knots[i % pieces]; };
    const auto slope = [&](std::size_t i) { return (knot(i + 1) - knot(i + pieces - 1)) / (2.0 * pieceM); };
    std::vector<osgRoads::core::Cubic> cubics;
    for (std::size_t i = 0; static_cast<double>(i) * pieceM < lengthM + beyondM; ++i)
    {
        const double rise = (knot(i + 1) - knot(i)) / pieceM, from = slope(i), to = slope(i + 1);
        cubics.push_back({static_cast<double>(i) * pieceM, knot(i), from,
                          (3.0 * rise - 2.0 * from - to) / pieceM,
                          (from + to - 2.0 * rise) / (pieceM * pieceM)});
    }
    return osgRoads::core::CubicProfile(std::move(cubics));
}

} // namespace islandgen
