// SPDX-License-Identifier: Apache-2.0
// Source: Ericson, *Real-Time Collision Detection*, 2005, 4.4.1 (separating axes of boxes).
#include "simulation/player/EntityDistance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <foundation/Angle.h>
#include <foundation/NearestOnSegment.h>
#include <glm/geometric.hpp>

#include "simulation/road/RoadWalk.h"

namespace simulation
{
namespace
{

struct Extent
{
    double least = 0.0, most = 0.0;
};

std::array<glm::dvec2, 4> corners(const MeasuredBody& body)
{
    const double heading = foundation::radiansOf(body.state->headingDeg);
    const glm::dvec2 forward(std::cos(heading), std::sin(heading));
    const glm::dvec2 left(-forward.y, forward.x);
    const glm::dvec2 middle =
        glm::dvec2(body.state->position) + forward * body.box.centre.x + left * body.box.centre.y;
    const glm::dvec2 halfLength = forward * (0.5 * body.box.lengthM);
    const glm::dvec2 halfWidth = left * (0.5 * body.box.widthM);
    return {middle + halfLength + halfWidth, middle + halfLength - halfWidth, middle - halfLength - halfWidth,
            middle - halfLength + halfWidth};
}

/// The extent of a box along an axis, from an origin.
Extent along(const MeasuredBody& body, glm::dvec2 origin, glm::dvec2 axis)
{
    Extent extent{1e300, -1e300};
    for (const glm::dvec2& corner : corners(body))
    {
        const double at = glm::dot(corner - origin, axis);
        extent.least = std::min(extent.least, at);
        extent.most = std::max(extent.most, at);
    }
    return extent;
}

double gap(const Extent& own, const Extent& other)
{
    if (other.least > own.most) return other.least - own.most;
    if (other.most < own.least) return other.most - own.least;
    return 0.0;
}

double alongAxis(const MeasuredBody& from, const MeasuredBody& to, glm::dvec2 axis, bool isFreespace)
{
    const glm::dvec2 origin(from.state->position);
    if (!isFreespace) return glm::dot(glm::dvec2(to.state->position) - origin, axis);
    return gap(along(from, origin, axis), along(to, origin, axis));
}

/// The distance of the boxes in the plan view: the least of all corners to all sides.
double betweenBoxes(const MeasuredBody& from, const MeasuredBody& to)
{
    if (overlap(from, to)) return 0.0;
    double least = 1e300;
    const auto toSides = [&](const std::array<glm::dvec2, 4>& points, const std::array<glm::dvec2, 4>& box)
    {
        for (const glm::dvec2& point : points)
            for (std::size_t i = 0; i < 4; ++i)
            {
                const glm::dvec2 nearest = foundation::nearestOnSegment(point, box[i], box[(i + 1) % 4]);
                least = std::min(least, glm::distance(point, nearest));
            }
    };
    toSides(corners(from), corners(to));
    toSides(corners(to), corners(from));
    return least;
}

/// How far a box reaches along the reference line before and behind its reference point, in the direction in
/// which `from` looks: of its corners, each by the circle that the road follows there.
Extent alongRoad(const MeasuredBody& body, bool isForward)
{
    const RoadPlace& place = *body.state->place;
    const double cosine = std::cos(place.relativeHeadingRad), sine = std::sin(place.relativeHeadingRad);
    Extent extent{1e300, -1e300};
    for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
        {
            const double ahead = body.box.centre.x + x * body.box.lengthM;
            const double left = body.box.centre.y + y * body.box.widthM;
            const double inwards = 1.0 - place.curvature * (place.t + sine * ahead + cosine * left);
            const double metres = (cosine * ahead - sine * left) / std::max(inwards, 0.05);
            extent.least = std::min(extent.least, isForward ? metres : -metres);
            extent.most = std::max(extent.most, isForward ? metres : -metres);
        }
    return extent;
}

/// How long a metre of the reference line is at the t of a place.
double lengthBeside(const RoadPlace& place)
{
    return 1.0 - place.curvature * place.t;
}

std::optional<double> onRoads(const MeasuredBody& from, const MeasuredBody& to,
                              const DistanceMeasure& measure, const RoadScene& roads)
{
    if (!from.state->place || !to.state->place) return std::nullopt;
    if (measure.kind == DistanceKind::lateral) return to.state->place->t - from.state->place->t;
    auto metres = distanceAlong(roads, *from.state->place, *to.state->place);
    if (metres && measure.frame == DistanceFrame::lane)
        *metres *= 0.5 * (lengthBeside(*from.state->place) + lengthBeside(*to.state->place));
    if (!metres || !measure.isFreespace) return metres;
    const bool isForward = std::cos(from.state->place->relativeHeadingRad) >= 0.0;
    Extent other = alongRoad(to, isForward);
    other.least += *metres;
    other.most += *metres;
    return gap(alongRoad(from, isForward), other);
}

} // namespace

std::optional<double> distanceBetween(const MeasuredBody& from, const MeasuredBody& to,
                                      const DistanceMeasure& measure, const RoadScene* roads)
{
    if (measure.kind == DistanceKind::euclidean)
        return measure.isFreespace
                   ? betweenBoxes(from, to)
                   : glm::distance(glm::dvec2(from.state->position), glm::dvec2(to.state->position));
    const bool isLateral = measure.kind == DistanceKind::lateral;
    if (measure.frame == DistanceFrame::world)
        return alongAxis(from, to, isLateral ? glm::dvec2(0.0, 1.0) : glm::dvec2(1.0, 0.0),
                         measure.isFreespace);
    if (measure.frame != DistanceFrame::entity && roads) return onRoads(from, to, measure, *roads);
    const double heading = foundation::radiansOf(from.state->headingDeg);
    const glm::dvec2 forward(std::cos(heading), std::sin(heading));
    return alongAxis(from, to, isLateral ? glm::dvec2(-forward.y, forward.x) : forward, measure.isFreespace);
}

double reachOf(const BoundingBox& box)
{
    return std::hypot(std::fabs(box.centre.x) + 0.5 * box.lengthM,
                      std::fabs(box.centre.y) + 0.5 * box.widthM);
}

bool overlap(const MeasuredBody& first, const MeasuredBody& second)
{
    const glm::dvec2 apart(second.state->position - first.state->position);
    const double reach = reachOf(first.box) + reachOf(second.box);
    if (glm::dot(apart, apart) > reach * reach) return false; // spares most of the angles
    for (const MeasuredBody* body : {&first, &second})
    {
        const double heading = foundation::radiansOf(body->state->headingDeg);
        const glm::dvec2 forward(std::cos(heading), std::sin(heading));
        for (const glm::dvec2& axis : {forward, glm::dvec2(-forward.y, forward.x)})
        {
            const Extent one = along(first, glm::dvec2(first.state->position), axis);
            const Extent two = along(second, glm::dvec2(first.state->position), axis);
            if (one.most < two.least || two.most < one.least) return false;
        }
    }
    return true;
}

} // namespace simulation
