// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/check/LevelCheck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <foundation/NearestOnSegment.h>
#include <glm/glm.hpp>

#include "scenery/buildings/Outline.h"
#include "worldmaking/plan/PlanGrid.h"

namespace worldmaking
{

namespace
{

constexpr double kPlaceM = 10.0;
constexpr double kBeyondM = 6.0, kLowM = 0.3;
constexpr double kSampledM = 5.0; ///< along a course, that samples of the ground are off
constexpr int kMostPlaces = 200;  ///< along a side of the box around water

double heightOr(const foundation::HeightInPlan& elevationM, const glm::dvec2& place, LevelFigures& figures)
{
    const auto height = elevationM(place);
    figures.isKnown = figures.isKnown && height.has_value();
    return height.value_or(0.0);
}

/// Finds the courses of rivers within water.
class Courses
{
public:
    Courses(const PlanRings& lines, const PlanRings& rings) : _rings(rings)
    {
        const MapBox box = boxOf(rings.front());
        for (const auto& line : lines)
            for (std::size_t i = 0; i + 1 < line.size(); ++i)
                if (boxOf({line[i], line[i + 1]}).meets(box)) _pieces.emplace_back(line[i], line[i + 1]);
    }

    /// A place of a course, and its direction there.
    struct At
    {
        glm::dvec2 place{0.0}, along{1.0, 0.0};
    };

    /// The nearest place of a course, if it is within kCourseM.
    std::optional<At> nearest(const glm::dvec2& place) const
    {
        std::optional<At> found;
        double leastM = kCourseM;
        for (const auto& [a, b] : _pieces)
        {
            const glm::dvec2 along = b - a, nearest = foundation::nearestOnSegment(place, a, b);
            const double awayM = glm::distance(place, nearest);
            if (awayM >= leastM) continue;
            leastM = awayM;
            found = At{nearest, along / std::max(glm::length(along), 1e-6)};
        }
        return found;
    }

    /// Whether a river goes on beyond an edge of its area: there the course leads away with it, and it has no
    /// shore.
    bool leadOut(const glm::dvec2& edge, const glm::dvec2& beyond) const
    {
        const auto here = nearest(edge), there = nearest(beyond);
        return here && there &&
               glm::distance(beyond, there->place) < glm::distance(edge, here->place) + 0.5 * kBeyondM;
    }

    /// How courses fall and rise within the water.
    void addFalls(const foundation::HeightInPlan& elevationM, LevelFigures& figures) const
    {
        for (const auto& [a, b] : _pieces)
        {
            const double lengthM = glm::distance(a, b);
            const int steps = std::max(1, static_cast<int>(lengthM / kPlaceM));
            for (int i = 0; i < steps && lengthM > kBeyondM; ++i)
            {
                const glm::dvec2 from = glm::mix(a, b, static_cast<double>(i) / steps),
                                 to = glm::mix(a, b, (i + 1.0) / steps);
                if (!scenery::isWithin(_rings, from) || !scenery::isWithin(_rings, to)) continue;
                const double fall =
                    (heightOr(elevationM, from, figures) - heightOr(elevationM, to, figures)) / lengthM *
                    steps;
                figures.fall = std::max(figures.fall, fall);
                figures.rise = std::max(figures.rise, -fall);
            }
        }
    }

private:
    const PlanRings& _rings;
    std::vector<std::pair<glm::dvec2, glm::dvec2>> _pieces;
};

/// The slope between a place of water and the next ones, or of a river to its course.
double slopeAt(const glm::dvec2& place, double stepM, const PlanRings& rings, const Courses& courses,
               const foundation::HeightInPlan& elevationM, LevelFigures& figures)
{
    const double height = heightOr(elevationM, place, figures);
    const auto awayM = [&](const glm::dvec2& other)
    { return std::abs(heightOr(elevationM, other, figures) - height); };
    if (const auto course = courses.nearest(place))
    {
        if (!scenery::isWithin(rings, course->place)) return 0.0;
        // At a rapid the ground, of samples, lies as the course does some metres up or down.
        double lowM = 1e300, highM = -1e300;
        for (const double alongM : {-kSampledM, 0.0, kSampledM})
        {
            const double its = heightOr(elevationM, course->place + alongM * course->along, figures);
            lowM = std::min(lowM, its), highM = std::max(highM, its);
        }
        const double offM = std::max({0.0, height - highM, lowM - height});
        return std::max(0.0, offM - kLowM) / std::max(kPlaceM, glm::distance(place, course->place));
    }
    double slope = 0.0;
    for (const glm::dvec2 step : {glm::dvec2(stepM, 0.0), glm::dvec2(0.0, stepM)})
        if (scenery::isWithin(rings, place + step) && !courses.nearest(place + step))
            slope = std::max(slope, awayM(place + step) / stepM);
    return slope;
}

/// The slopes of a grid of places within rings.
void addSlopes(const PlanRings& rings, const Courses& courses, const foundation::HeightInPlan& elevationM,
               LevelFigures& figures)
{
    const MapBox box = boxOf(rings.front());
    const glm::dvec2 size = box.high - box.low;
    const double stepM = std::max(kPlaceM, std::max(size.x, size.y) / kMostPlaces);
    for (double north = box.low.y; north <= box.high.y; north += stepM)
        for (double east = box.low.x; east <= box.high.x; east += stepM)
        {
            const glm::dvec2 place(east, north);
            if (!scenery::isWithin(rings, place)) continue;
            const double slope = slopeAt(place, stepM, rings, courses, elevationM, figures);
            if (slope <= figures.slope) continue;
            figures.slope = slope;
            figures.steepAt = place;
        }
}

} // namespace

LevelFigures runwayFigures(const glm::dvec2& from, const glm::dvec2& to, double widthM,
                           const foundation::HeightInPlan& elevationM)
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

LevelFigures waterFigures(const PlanRings& rings, const PlanRings& lines,
                          const foundation::HeightInPlan& elevationM)
{
    LevelFigures figures;
    const Courses courses(lines, rings);
    addSlopes(rings, courses, elevationM, figures);
    courses.addFalls(elevationM, figures);
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
                if (courses.leadOut(edge, edge + side * out)) continue;
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
    return figures.slope <= 0.1 && figures.fall <= 0.5 && figures.rise <= 0.03 && figures.lowShore <= 0.1;
}

} // namespace worldmaking
