// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "simulation/vehicle/road/RoadVehicleData.h"

namespace simulation
{

/// How a tyre moves over the ground at its contact. Frame: x along the wheel, y to its left, on the ground.
/// Units: m/s.
struct TyreMotion
{
    double rollingMps = 0.0;      ///< of the hub, along the wheel
    double slidingAlongMps = 0.0; ///< of the tread over the ground: rollingMps less the wheel's turning
    double slidingAcrossMps = 0.0;
};

/// What a tyre does at its contact.
struct TyreForce
{
    glm::dvec2 forceN{0.0}; ///< on the wheel, x along, y to the left
    double slip = 0.0;      ///< over that at which the whole contact slides: friction peaks at 1
};

/// Bends a tyre for a step and returns its force.
///
/// The contact is a spring along and across (`bend`, metres) that the sliding bends and the rolling
/// straightens within a relaxation length; the bend stands for the slip of a brush model with a parabolic
/// pressure, isotropic in slip over that at which all slides. So forces of both directions share one
/// friction, lag as in a real tyre, and hold a standing vehicle as a spring. Beyond the peak friction falls
/// to its sliding share. Near standstill a damper is added.
/// Source: Pacejka, *Tire and Vehicle Dynamics*, 2nd edition, 2006, section 3.2 (brush model, combined slip)
/// and chapter 8 (single contact point transient model).
/// Differs: friction differs along and across; the bend is bounded so that grip comes back soon after
/// sliding.
TyreForce tyreForce(const RoadTyreData& tyre, double loadN, double gripFactor, const TyreMotion& motion,
                    double stepS, glm::dvec2& bend);

/// Stiffness at a load: force over slip (x) and over radian of slip angle (y). Units: N.
glm::dvec2 tyreStiffness(const RoadTyreData& tyre, double loadN);

/// Peak friction at a load, along and across.
glm::dvec2 tyreFriction(const RoadTyreData& tyre, double loadN, double gripFactor);

} // namespace simulation
