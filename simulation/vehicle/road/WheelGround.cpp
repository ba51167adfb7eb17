// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/WheelGround.h"

#include <algorithm>
#include <cmath>

#include <foundation/NearestOnSegment.h>

#include "simulation/vehicle/road/Roughness.h"

namespace simulation
{

namespace
{

constexpr double kReach = 0.8;     ///< of the radius, before and behind the hub
constexpr double kSpacingM = 0.13; ///< most, where the number of points allows it
constexpr std::size_t kFewestHeights = 7;

/// A direction across a horizontal one, to its left.
glm::dvec3 leftOf(const glm::dvec3& forward)
{
    return {-forward.y, forward.x, 0.0};
}

} // namespace

std::span<const glm::dvec3> WheelGround::pointsFor(const glm::dvec3& hub, const glm::dvec3& forward,
                                                   double radiusM, double widthM, double travelM)
{
    _origin = hub;
    _forward = forward;
    _widthM = widthM;
    const double first = -kReach * radiusM + std::min(0.0, travelM);
    const double last = kReach * radiusM + std::max(0.0, travelM);
    const auto wanted = static_cast<std::size_t>(std::min(1e3, std::ceil((last - first) / kSpacingM))) + 1;
    const std::size_t heights = std::clamp(wanted, kFewestHeights, kMostPoints - 2);
    _count = heights + 2;
    for (std::size_t i = 0; i < heights; ++i)
    {
        _along[i] = first + (last - first) * static_cast<double>(i) / static_cast<double>(heights - 1);
        _points[i] = hub + _along[i] * forward;
    }
    const glm::dvec3 side = 0.5 * widthM * leftOf(forward);
    _points[heights] = hub - side;
    _points[heights + 1] = hub + side;
    return {_points.data(), _count};
}

void WheelGround::take(std::span<const GroundPoint> answers)
{
    _isKnown = std::all_of(answers.begin(), answers.end(), [](const GroundPoint& p) { return p.isKnown; });
    if (!_isKnown) return;
    for (std::size_t i = 0; i < heights(); ++i)
        _heightM[i] = answers[i].heightM + roughnessM(answers[i].kind, _points[i]);
    const GroundPoint& right = answers[heights()];
    const GroundPoint& leftSide = answers[heights() + 1];
    _slopeAcross = (leftSide.heightM - right.heightM) / _widthM;
    _kind = leftSide.kind == right.kind ? right.kind : std::max(leftSide.kind, right.kind);
    _gripScale = std::min(leftSide.gripScale, right.gripScale);
}

WheelContact WheelGround::contactOf(const glm::dvec3& hub, double radiusM) const
{
    const glm::dvec3 left = leftOf(_forward);
    const glm::dvec3 moved = hub - _origin;
    const double along = glm::dot(moved, _forward), across = glm::dot(moved, left);
    // In the plane of the wheel: x along the way, y up.
    const glm::dvec2 middle(along, hub.z - across * _slopeAcross);
    WheelContact contact;
    contact.depthM = -1e9;
    glm::dvec2 touch(0.0), normal(0.0, 1.0);
    for (std::size_t i = 0; i + 1 < heights(); ++i)
    {
        const glm::dvec2 from(_along[i], _heightM[i]), to(_along[i + 1], _heightM[i + 1]);
        const glm::dvec2 piece = to - from;
        const double share = foundation::nearestShare(middle, from, to);
        const glm::dvec2 nearest = from + share * piece, apart = middle - nearest;
        const glm::dvec2 upwards = glm::normalize(glm::dvec2(-piece.y, piece.x));
        const double distance = glm::length(apart);
        const bool isBelow = glm::dot(apart, upwards) < 0.0;
        const double depth = isBelow ? radiusM + distance : radiusM - distance;
        // Pieces that the hub has not reached cannot lift it from below.
        if (isBelow && (middle.x < from.x || middle.x > to.x)) continue;
        if (depth <= contact.depthM) continue;
        contact.depthM = depth;
        touch = nearest;
        normal = isBelow || distance < 1e-6 ? upwards : apart / distance;
    }
    contact.place = _origin + touch.x * _forward + across * left;
    contact.place.z = touch.y + across * _slopeAcross;
    contact.normal =
        glm::normalize(normal.x * _forward + glm::dvec3(0.0, 0.0, normal.y) - normal.y * _slopeAcross * left);
    // A wheel on a cross slope is that much nearer to it.
    contact.depthM = radiusM - (radiusM - contact.depthM) / std::sqrt(1.0 + _slopeAcross * _slopeAcross);
    return contact;
}

} // namespace simulation
