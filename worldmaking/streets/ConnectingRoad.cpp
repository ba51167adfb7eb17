// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/ConnectingRoad.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <foundation/Angle.h>
#include <glm/geometric.hpp>

namespace worldmaking
{

namespace
{

using osgRoads::core::Cubic;
using osgRoads::core::CubicProfile;
using osgRoads::core::CurveCoefficients;
using osgRoads::core::Lane;
using osgRoads::core::ParametricCubic;
using osgRoads::core::PlanElement;
using osgRoads::core::PlanPoint;

constexpr double kHeightStepM = 4.0;
constexpr double kHeightTurnRad = 0.2; ///< and in bends no more than this: a plane's lean turns with them
constexpr int kMostHeightSteps = 100;

/// The cubic from 0 with one slope to `rise` with another, over a parameter from 0 to 1.
CurveCoefficients hermite(double startSlope, double rise, double endSlope)
{
    return {0.0, startSlope, 3.0 * rise - 2.0 * startSlope - endSlope, startSlope + endSlope - 2.0 * rise};
}

PlanElement curveBetween(const LaneGate& from, const LaneGate& to)
{
    const glm::dvec2 ahead(std::cos(from.headingRad), std::sin(from.headingRad)), left(-ahead.y, ahead.x);
    const glm::dvec2 way = to.edge - from.edge;
    const double turn = foundation::wrappedRad(to.headingRad - from.headingRad);
    const double cosine = std::cos(0.25 * turn), reach = std::max(glm::length(way), 0.1) / (cosine * cosine);
    const auto u = hermite(reach, glm::dot(way, ahead), reach * std::cos(turn));
    const auto v = hermite(0.0, glm::dot(way, left), reach * std::sin(turn));
    const double lengthM = ParametricCubic::normalized(u, v, 1.0).lengthRatio();
    return {0.0, lengthM, from.edge, from.headingRad, ParametricCubic::normalized(u, v, lengthM)};
}

/// How many pieces of equal length heights along a curve need.
int heightSteps(const osgRoads::core::Road& road)
{
    constexpr int kSamples = 32;
    double sharpest = 0.0;
    for (int i = 0; i <= kSamples; ++i)
        sharpest = std::max(sharpest, std::fabs(road.referenceLine.at(road.length * i / kSamples).curvature));
    const double steps = road.length * std::max(1.0 / kHeightStepM, sharpest / kHeightTurnRad);
    return static_cast<int>(std::clamp(std::ceil(steps), 1.0, static_cast<double>(kMostHeightSteps)));
}

/// Heights and lean of a plane along a curve, exact at the ends of all pieces in value and slope.
void layOnPlane(osgRoads::core::Road& road, const CrossingPlane& plane)
{
    const int count = glm::length(plane.gradient) > 0.0 ? heightSteps(road) : 1;
    std::vector<Cubic> heights, leans;
    const double stepM = road.length / count;
    struct Sample
    {
        double height, grade, lean, leanRate;
    };
    const auto sampleAt = [&](double s)
    {
        const PlanPoint point = road.referenceLine.at(s);
        const glm::dvec2 tangent = point.tangent(), left(-tangent.y, tangent.x);
        const double grade = glm::dot(plane.gradient, tangent), across = glm::dot(plane.gradient, left);
        return Sample{plane.at(point.position), grade, std::atan(across),
                      -point.curvature * grade / (1.0 + across * across)};
    };
    Sample before = sampleAt(0.0);
    for (int i = 0; i < count; ++i)
    {
        const Sample after = sampleAt((i + 1) * stepM);
        heights.push_back(
            hermitePiece(i * stepM, stepM, before.height, before.grade, after.height, after.grade));
        leans.push_back(
            hermitePiece(i * stepM, stepM, before.lean, before.leanRate, after.lean, after.leanRate));
        before = after;
    }
    road.elevation = CubicProfile(std::move(heights));
    if (glm::length(plane.gradient) > 0.0) road.superelevationRad = CubicProfile(std::move(leans));
}

} // namespace

osgRoads::core::Cubic hermitePiece(double s, double lengthM, double value, double slope, double nextValue,
                                   double nextSlope)
{
    const auto c = hermite(slope * lengthM, nextValue - value, nextSlope * lengthM);
    return {s, value, slope, c.c / (lengthM * lengthM), c.d / (lengthM * lengthM * lengthM)};
}

osgRoads::core::Road connectingRoad(const LaneGate& from, const LaneGate& to, const CrossingPlane& plane)
{
    osgRoads::core::Road road;
    const PlanElement curve = curveBetween(from, to);
    road.length = curve.length;
    road.referenceLine = osgRoads::core::ReferenceLine({curve});
    layOnPlane(road, plane);
    osgRoads::core::LaneSection section;
    section.end = road.length;
    Lane lane;
    lane.id = -1;
    lane.type = osgRoads::core::LaneType::driving;
    lane.width = CubicProfile({hermitePiece(0.0, road.length, from.widthM, 0.0, to.widthM, 0.0)});
    section.right.push_back(std::move(lane));
    road.sections.push_back(std::move(section));
    road.isUsable = true;
    return road;
}

} // namespace worldmaking
