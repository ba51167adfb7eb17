// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 10.5 (elevation), 11.8 (lane height); 1.4, 5.3.6.2 (crossfall).
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>

namespace osgRoads::core
{

namespace
{

constexpr int kSurfaceSteps = 6;
constexpr double kDifferenceM = 1e-5; ///< step of the derivatives of the height, which is small and smooth

double mix(double from, double to, double share)
{
    return from + (to - from) * share;
}

double shapeHeight(const std::vector<ShapeSection>& shapes, double s, double t)
{
    const int index = std::max(lastStartingBy(shapes, s), 0);
    const ShapeSection& here = shapes[static_cast<std::size_t>(index)];
    const double height = here.heights.value(t);
    if (static_cast<std::size_t>(index) + 1 == shapes.size() || s < here.s) return height;
    const ShapeSection& next = shapes[static_cast<std::size_t>(index) + 1];
    return mix(height, next.heights.value(t), (s - here.s) / (next.s - here.s));
}

/// The road itself, without what lanes add.
double crossSectionHeight(const Road& road, double s, double t)
{
    if (!road.shapes.empty()) return shapeHeight(road.shapes, s, t);
    const CubicProfile& angle = t >= 0.0 ? road.crossfall.leftRad : road.crossfall.rightRad;
    return angle.isEmpty() ? 0.0 : -std::fabs(t) * std::tan(angle.value(s));
}

double laneHeightAt(const LaneSpan& span, double ds, double t)
{
    const std::vector<LaneHeight>& heights = span.lane->heights;
    if (heights.empty()) return 0.0;
    const int index = lastStartingBy(heights, ds);
    if (index < 0) return 0.0;
    LaneHeight height = heights[static_cast<std::size_t>(index)];
    if (static_cast<std::size_t>(index) + 1 < heights.size())
    {
        const LaneHeight& next = heights[static_cast<std::size_t>(index) + 1];
        const double share = next.s > height.s ? (ds - height.s) / (next.s - height.s) : 0.0;
        height.inner = mix(height.inner, next.inner, share);
        height.outer = mix(height.outer, next.outer, share);
    }
    const double width = span.width();
    const double across = width > 0.0 ? std::fabs(t - span.innerT) / width : 0.0;
    return mix(height.inner, height.outer, std::clamp(across, 0.0, 1.0));
}

/// What lanes at (s, t) say: their height, and where the level ones begin.
struct LaneSurface
{
    double height = 0.0;
    bool isLevel = false;
    double levelFromT = 0.0;
};

LaneSurface laneSurfaceAt(const Road& road, double s, double t)
{
    LaneSurface surface;
    const LaneSection* section = sectionAt(road, s);
    if (!section) return surface;
    const int sign = t >= road.laneOffset.value(s) ? 1 : -1;
    forLanesOutwards(road, *section, sign, s,
                     [&](const LaneSpan& span)
                     {
                         if (span.lane->isLevel && !surface.isLevel) surface.levelFromT = span.innerT;
                         surface.isLevel = span.lane->isLevel;
                         if (sign * (t - span.outerT) > 0.0) return true; // farther out
                         surface.height = laneHeightAt(span, s - section->s, t);
                         return false;
                     });
    return surface;
}

} // namespace

RoadFrame frameAt(const Road& road, double s, const PlanPoint& point)
{
    RoadFrame frame;
    frame.tangent = point.tangent();
    frame.headingRad = point.headingRad;
    frame.curvature = point.curvature;
    frame.origin = glm::dvec3(point.position, road.elevation.value(s));
    frame.slope = road.elevation.slope(s);
    if (road.hasTilt())
    {
        frame.rollRad = road.superelevationRad.value(s);
        frame.rollRate = road.superelevationRad.slope(s);
        frame.cosRoll = std::cos(frame.rollRad);
        frame.sinRoll = std::sin(frame.rollRad);
    }
    return frame;
}

RoadFrame frameAt(const Road& road, double s)
{
    return frameAt(road, s, road.referenceLine.at(s));
}

double surfaceHeight(const Road& road, double s, double t)
{
    const LaneSurface lanes = laneSurfaceAt(road, s, t);
    if (!lanes.isLevel) return crossSectionHeight(road, s, t) + lanes.height;
    // Level: as high as the border where the level lanes begin, in the inertial frame.
    const double tangent = road.hasTilt() ? std::tan(road.superelevationRad.value(s)) : 0.0;
    return crossSectionHeight(road, s, lanes.levelFromT) - tangent * (t - lanes.levelFromT) + lanes.height;
}

glm::dvec3 surfacePoint(const Road& road, double s, double t)
{
    return frameAt(road, s).pointAt(t, surfaceHeight(road, s, t));
}

glm::dvec3 surfaceNormal(const Road& road, double s, double t)
{
    const RoadFrame frame = frameAt(road, s);
    const double h = surfaceHeight(road, s, t);
    // The lane in which the point lies decides on which side the differences are taken.
    const std::optional<LaneSpan> lane = laneAt(road, s, t);
    const double middle = lane ? lane->centreT() : 0.0;
    const double dt = lane && middle < t ? -kDifferenceM : kDifferenceM;
    const double ds = s + kDifferenceM < road.length ? kDifferenceM : -kDifferenceM;
    const double across = (surfaceHeight(road, s, t + dt) - h) / dt;
    const double along = (surfaceHeight(road, s + ds, t) - h) / ds;
    const double lateral = t * frame.cosRoll - h * frame.sinRoll;
    const double up = t * frame.sinRoll + h * frame.cosRoll;
    // Derivatives by s and t in the axes tangent, left, up; turning with the roll moves (lateral, up) to
    // (-up, lateral).
    const glm::dvec3 byS(1.0 - frame.curvature * lateral, -up * frame.rollRate - along * frame.sinRoll,
                         frame.slope + lateral * frame.rollRate + along * frame.cosRoll);
    const glm::dvec3 byT(0.0, frame.cosRoll - across * frame.sinRoll, frame.sinRoll + across * frame.cosRoll);
    const glm::dvec3 normal = glm::cross(byS, byT);
    const glm::dvec2 level = normal.x * frame.tangent + normal.y * frame.left();
    const glm::dvec3 inertial(level, normal.z);
    const double length = glm::length(inertial);
    return length > 0.0 ? inertial / length : glm::dvec3(0.0, 0.0, 1.0);
}

double surfaceT(const Road& road, const RoadFrame& frame, double s, double lateral)
{
    if (!road.hasTilt()) return lateral;
    double t = lateral / frame.cosRoll;
    for (int step = 0; step < kSurfaceSteps; ++step)
    {
        const double next = (lateral + surfaceHeight(road, s, t) * frame.sinRoll) / frame.cosRoll;
        const bool isReached = !(std::fabs(next - t) > 1e-9);
        t = next;
        if (isReached) break;
    }
    return t;
}

const RoadStructure* structureAt(const Road& road, double s)
{
    for (const RoadStructure& structure : road.structures)
        if (s >= structure.s && s <= structure.s + structure.length) return &structure;
    return nullptr;
}

} // namespace osgRoads::core
