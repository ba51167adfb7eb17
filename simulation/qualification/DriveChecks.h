// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "simulation/qualification/QualificationCheck.h"
#include "simulation/vehicle/road/RoadVehicleData.h"

namespace simulation
{

/// Acceleration, braking distance and lateral acceleration on dry asphalt, against the figures that the
/// vehicle's file states. A figure that is not reached at all is not a number and fails.
QualificationChecks performanceChecks(const std::shared_ptr<const RoadVehicleData>& vehicle);

/// Steady turn and step steer in the linear range, against the single-track model of the vehicle's masses and
/// tyres.
/// Source: Riekert, Schunck, *Zur Fahrmechanik des gummibereiften Kraftfahrzeugs*, 1940; Rill, *Road Vehicle
/// Dynamics*, 2011, section 7.3.
QualificationChecks steeringChecks(const std::shared_ptr<const RoadVehicleData>& vehicle);

/// Braking with ABS from 20 to 2 m/s on each kind of ground, against what the tyres' friction allows at the
/// loads of the braking.
QualificationChecks frictionChecks(const std::shared_ptr<const RoadVehicleData>& vehicle);

/// How far the vehicle creeps with its handbrake on a slope of 15 % within a time, and how it comes over a
/// kerb at 70 m/s.
QualificationChecks holdingChecks(const std::shared_ptr<const RoadVehicleData>& vehicle,
                                  double standsS = 3600.0);

} // namespace simulation
