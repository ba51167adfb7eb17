// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/Airfield.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace worldmaking
{

namespace
{

constexpr double kRunwaySearchM = 200.0, kRunwayBorderM = 1200.0, kRunwaySampleM = 100.0, kStripHalfM = 60.0;
constexpr double kApronSideM = 190.0; ///< ground on the side of the apron that has to be level too
constexpr int kRunwayDirections = 12;

/// How far the ground of a strip is from the line between its ends, at most; nothing where it is too steep or
/// no land.
std::optional<double> unevenM(const GroundGrid& ground, const glm::dvec2& from, const glm::dvec2& to,
                              const glm::dvec2& apronSide, double best)
{
    const auto begin = ground.heightM(from), end = ground.heightM(to);
    const double lengthM = glm::distance(from, to);
    if (!begin || !end || std::abs(*end - *begin) > kMostGrade * lengthM) return std::nullopt;
    double worst = 0.0;
    for (double at = -kRunwaySampleM; at <= lengthM + kRunwaySampleM; at += kRunwaySampleM)
        for (const double side : {0.0, kStripHalfM, -kStripHalfM, 0.5 * kApronSideM, kApronSideM})
        {
            const glm::dvec2 place = glm::mix(from, to, at / lengthM) + side * apronSide;
            if (!ground.isLand(place)) return std::nullopt;
            const double line = *begin + (*end - *begin) * std::clamp(at / lengthM, 0.0, 1.0);
            worst = std::max(worst, std::abs(*ground.heightM(place) - line));
            if (worst >= best) return std::nullopt;
        }
    return worst;
}

} // namespace

std::optional<Airfield> airfieldOn(const GroundGrid& ground)
{
    const MapBox& box = ground.box();
    const double border =
        std::min(kRunwayBorderM, 0.15 * std::min(box.high.x - box.low.x, box.high.y - box.low.y));
    std::optional<Airfield> found;
    double best = kMostUnevenM;
    for (double y = box.low.y + border; y < box.high.y - border; y += kRunwaySearchM)
        for (double x = box.low.x + border; x < box.high.x - border; x += kRunwaySearchM)
            for (int i = 0; i < kRunwayDirections; ++i)
            {
                if (!ground.isLand({x, y})) break;
                const double angle = std::numbers::pi * i / kRunwayDirections;
                const glm::dvec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
                const glm::dvec2 half = 0.5 * Airfield::kLengthM * along;
                for (const double side : {1.0, -1.0})
                    if (const auto uneven = unevenM(ground, glm::dvec2(x, y) - half, glm::dvec2(x, y) + half,
                                                    side * across, best))
                    {
                        best = *uneven;
                        found =
                            Airfield{glm::dvec2(x, y) - half, glm::dvec2(x, y) + half, side * across, best};
                    }
            }
    return found;
}

PlanRings Airfield::ground() const
{
    const glm::dvec2 end = 120.0 * along(), near = 75.0 * apronSide, far = (kApronSideM + 25.0) * apronSide;
    return {{from - end - near, to + end - near, to + end + far, from - end + far}};
}

std::vector<PlanRings> Airfield::approaches() const
{
    std::vector<PlanRings> wedges;
    for (const auto& [end, away] : {std::pair(from, -along()), std::pair(to, along())})
    {
        const glm::dvec2 across(-away.y, away.x), far = end + 900.0 * away;
        wedges.push_back(
            {{end - 80.0 * across, far - 190.0 * across, far + 190.0 * across, end + 80.0 * across}});
    }
    return wedges;
}

glm::dvec2 Airfield::gate() const
{
    return glm::mix(from, to, 0.42) + (kApronSideM + 70.0) * apronSide;
}

std::string Airfield::designators() const
{
    const glm::dvec2 way = along();
    const double heading = std::atan2(way.x, way.y) * 180.0 / std::numbers::pi;
    const int number = (static_cast<int>(std::lround(heading / 10.0)) + 36) % 36;
    const int one = number == 0 ? 36 : number, other = (one + 17) % 36 + 1;
    char text[16];
    std::snprintf(text, sizeof text, "%02d/%02d", one, other);
    return text;
}

MadeShapes Airfield::shapes() const
{
    const glm::dvec2 way = along();
    const auto at = [&](double share, double sideM) { return glm::mix(from, to, share) + sideM * apronSide; };
    MadeShapes shapes;
    shapes.push_back(lineShape({at(0.03, 0.0), at(0.03, 85.0), at(0.97, 85.0), at(0.97, 0.0)},
                               {{"aeroway", "taxiway"}, {"width", "12"}, {"surface", "asphalt"}}));
    for (const double share : {0.36, 0.48})
        shapes.push_back(lineShape({at(share, 0.0), at(share, 112.0)},
                                   {{"aeroway", "taxiway"}, {"width", "12"}, {"surface", "asphalt"}}));
    shapes.push_back(lineShape({at(0.36, 112.0), at(0.48, 112.0)},
                               {{"aeroway", "taxilane"}, {"width", "8"}, {"surface", "asphalt"}}));
    shapes.push_back(areaShape(rectangleOf(at(0.42, 130.0), way, 260.0, 60.0),
                               {{"aeroway", "apron"}, {"surface", "asphalt"}}));
    for (const double share : {0.345, 0.375, 0.405})
        shapes.push_back(areaShape(
            rectangleOf(at(share, 174.0), way, 22.0, 30.0),
            {{"building", "hangar"}, {"aeroway", "hangar"}, {"height", "9"}, {"roof:height", "4"}}));
    shapes.push_back(areaShape(rectangleOf(at(0.455, 172.0), way, 24.0, 11.0),
                               {{"building", "office"}, {"aeroway", "terminal"}, {"building:levels", "2"}}));
    shapes.push_back(areaShape(rectangleOf(at(0.472, 174.0), way, 7.0, 7.0), {{"building", "tower"},
                                                                              {"aeroway", "tower"},
                                                                              {"service", "aircraft_control"},
                                                                              {"height", "17"},
                                                                              {"building:levels", "5"},
                                                                              {"roof:shape", "flat"}}));
    shapes.push_back(
        areaShape(rectangleOf(at(0.325, 171.0), way, 16.0, 14.0),
                  {{"building", "fire_station"}, {"building:levels", "2"}, {"roof:shape", "flat"}}));
    for (const double aheadM : {-5.5, 5.5}) // fuel
        shapes.push_back(
            pointShape(at(0.50, 166.0) + aheadM * way, {{"man_made", "storage_tank"}, {"height", "5"}}));
    for (const double share : {0.335, 0.39, 0.445}) // floods, behind the apron's edge
        shapes.push_back(pointShape(at(share, 163.0), {{"man_made", "mast"}, {"height", "14"}}));
    PlanRings around = ground();
    around.front().push_back(around.front().front());
    shapes.push_back(lineShape(std::move(around.front()), {{"barrier", "fence"}, {"height", "2"}}));
    shapes.push_back(pointShape(at(0.12, 55.0), {{"aeroway", "windsock"}}));
    return shapes;
}

} // namespace worldmaking
