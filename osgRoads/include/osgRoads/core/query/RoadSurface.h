// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <osgRoads/core/network/Road.h>

namespace osgRoads::core
{

/// The frame of a road at one s: its origin on the reference line at the elevation, t across, h up.
/// Superelevation turns t and h about the horizontal tangent. The cross-section is vertical and stands at
/// right angles to the reference line in the plan view, so that s does not depend on heights.
/// Source: ASAM OpenDRIVE 1.8, 8.3 (reference line coordinate systems), 10.5.1, 10.5.2.
/// Differs: the frame is not pitched by the elevation; h of a post is vertical on a road that climbs.
struct RoadFrame
{
    glm::dvec3 origin{0.0, 0.0, 0.0};
    glm::dvec2 tangent{1.0, 0.0}; ///< horizontal unit vector towards greater s
    double headingRad = 0.0;
    double curvature = 0.0; ///< of the plan view, 1/m
    double slope = 0.0;     ///< dz/ds
    double rollRad = 0.0;   ///< superelevation: positive lifts the left side
    double rollRate = 0.0;  ///< rad/m
    double cosRoll = 1.0, sinRoll = 0.0;

    glm::dvec2 left() const { return {-tangent.y, tangent.x}; }

    /// Returns the inertial position of (t, h).
    glm::dvec3 pointAt(double t, double h) const
    {
        const double lateral = lateralOf(t, h);
        return {origin.x - tangent.y * lateral, origin.y + tangent.x * lateral,
                origin.z + t * sinRoll + h * cosRoll};
    }

    /// Returns how far (t, h) lies to the left of the reference line in the plan view.
    double lateralOf(double t, double h) const { return t * cosRoll - h * sinRoll; }

    /// Returns the (t, h) that lies `leftM` to the left of another in the plan view and `downM` lower,
    /// whatever the superelevation.
    glm::dvec2 moved(glm::dvec2 from, double leftM, double downM) const
    {
        return from + glm::dvec2(leftM * cosRoll - downM * sinRoll, -leftM * sinRoll - downM * cosRoll);
    }

    /// Returns (t, h) of an inertial position in the cross-section: the inverse of pointAt().
    glm::dvec2 across(const glm::dvec3& position) const
    {
        const double lateral = (position.y - origin.y) * tangent.x - (position.x - origin.x) * tangent.y;
        const double up = position.z - origin.z;
        return {lateral * cosRoll + up * sinRoll, up * cosRoll - lateral * sinRoll};
    }
};

RoadFrame frameAt(const Road& road, double s);

/// Makes the frame of a point of the reference line that has been computed already.
RoadFrame frameAt(const Road& road, double s, const PlanPoint& point);

/// Returns the h of the surface above the road plane at (s, t): shape or crossfall, level lanes, lane
/// heights. Beside the lanes shape and crossfall go on.
/// Source: ASAM OpenDRIVE 1.8, 10.5.3 (shape), 11.8 (lane height), 11.2 (level); 1.4, 5.3.6.2 (crossfall).
double surfaceHeight(const Road& road, double s, double t);

/// Returns the inertial position of the surface at (s, t).
glm::dvec3 surfacePoint(const Road& road, double s, double t);

/// Returns the unit normal of the surface at (s, t), upwards. Steps between lanes count as vertical walls
/// without width.
glm::dvec3 surfaceNormal(const Road& road, double s, double t);

/// Returns the t of the point of the surface whose plan-view distance from the reference line is `lateral`
/// (left positive).
double surfaceT(const Road& road, const RoadFrame& frame, double s, double lateral);

/// Returns the bridge or tunnel at s, or nullptr.
const RoadStructure* structureAt(const Road& road, double s);

} // namespace osgRoads::core
