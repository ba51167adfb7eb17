// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/check/LevelCheck.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/glm.hpp>

#include "scenery/buildings/Outline.h"
#include "worldmaking/land/PlanGrid.h"

namespace worldmaking
{

namespace
{

constexpr double kPlaceM = 10.0;
constexpr double kBeyondM = 6.0, kLowM = 0.3;
constexpr int kMostPlaces = 200; ///< along a side of the box around water

double heightOr(const PlanHeight& elevationM, const glm::dvec2& place, LevelFigures& figures)
{
    const auto height = elevationM(place);
    figures.isKnown = figures.isKnown && height.has_value();
    return height.value_or(0.0);
}

/// The slopes between the places of a grid within rings.
void addSlopes(const PlanRings& rings, const PlanHeight& elevationM, LevelFigures& figures)
{
    const MapBox box = boxOf(rings.front());
    const glm::dvec2 size = box.high - box.low;
    const double stepM = std::max(kPlaceM, std::max(size.x, size.y) / kMostPlaces);
    const auto within = [&](const glm::dvec2& place) { return scenery::isWithin(rings, place); };
    for (double north = box.low.y; north <= box.high.y; north += stepM)
        for (double east = box.low.x; east <= box.high.x; east += stepM)
        {
            const glm::dvec2 place(east, north);
            if (!within(place)) continue;
            const double height = heightOr(elevationM, place, figures);
            for (const glm::dvec2 step : {glm::dvec2(stepM, 0.0), glm::dvec2(0.0, stepM)})
                if (within(place + step))
                    figures.slope =
                        std::max(figures.slope,
                                 std::abs(heightOr(elevationM, place + step, figures) - height) / stepM);
        }
}

} // namespace

LevelFigures runwayFigures(const glm::dvec2& from, const glm::dvec2& to, double widthM,
                           const PlanHeight& elevationM)
{
    LevelFigures figures;
    const glm::dvec2 along = glm::normalize(to - from), left(-along.y, along.x);
    const int steps = std::max(1, static_cast<int>(glm::distance(from, to) / kPlaceM));
    const double stepM = glm::distance(from, to) / steps;
    std::array<double, 3> before{}, slopeBefore{};
    for (int i = 0; i <= steps; ++i)
    {
        std::array<double, 3> heights{};
        for (std::size_t line = 0; line < 3; ++line)
        {
            const double side = 0.45 * (static_cast<double>(line) - 1.0);
            heights[line] = heightOr(elevationM, from + i * stepM * along + side * widthM * left, figures);
            const double slope = (heights[line] - before[line]) / stepM;
            if (i > 0) figures.slope = std::max(figures.slope, std::abs(slope));
            if (i > 1)
                figures.slopeChange = std::max(figures.slopeChange, std::abs(slope - slopeBefore[line]));
            slopeBefore[line] = slope;
        }
        for (const std::size_t edge : {std::size_t{0}, std::size_t{2}})
            figures.crossfall =
                std::max(figures.crossfall, std::abs(heights[1] - heights[edge]) / (0.45 * widthM));
        before = heights;
    }
    return figures;
}

LevelFigures waterFigures(const PlanRings& rings, const PlanHeight& elevationM)
{
    LevelFigures figures;
    addSlopes(rings, elevationM, figures);
    double places = 0.0, low = 0.0;
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
            const glm::dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
            const double lengthM = glm::distance(a, b);
            if (lengthM < 1.0) continue;
            const glm::dvec2 out = kBeyondM / lengthM * glm::dvec2(b.y - a.y, a.x - b.x);
            for (double at = 0.5 * std::min(kPlaceM, lengthM); at < lengthM; at += kPlaceM)
            {
                const glm::dvec2 edge = glm::mix(a, b, at / lengthM);
                const double side = scenery::isWithin(rings, edge + out) ? -1.0 : 1.0;
                const double besideM = heightOr(elevationM, edge + side * out, figures);
                places += 1.0;
                low += heightOr(elevationM, edge, figures) - besideM > kLowM ? 1.0 : 0.0;
            }
        }
    figures.lowShore = low / std::max(places, 1.0);
    return figures;
}

bool isEvenRunway(const LevelFigures& figures)
{
    return figures.slope <= 0.025 && figures.slopeChange <= 0.01 && figures.crossfall <= 0.025;
}

bool isEvenWater(const LevelFigures& figures)
{
    return figures.slope <= 0.1 && figures.lowShore <= 0.1;
}

} // namespace worldmaking
