// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <osg/Group>
#include <osg/Vec4f>

#include "simulation/player/AircraftParts.h"

namespace scenery
{

/// Makes a single-engined high-wing aeroplane of lofted sections, 8.1 m long, 11 m span, 2.75 m high: fuselage with
/// windows, strutted wing, tail, fixed gear and the blur of a turning propeller.
/// Frame: as OpenSCENARIO vehicles: origin on the ground below the axle of the main wheels, x forward, y left, z up;
/// metres. `trim`: colour of stripe and tips, display values. Needs the uniforms of an Atmosphere above it in the
/// graph.
osg::ref_ptr<osg::Group> makeLightAircraft(const osg::Vec4f& trim = {0.10F, 0.22F, 0.50F, 1.0F});

/// Puts the wheels of such an aircraft where they are on their struts, and shows the blur of the propeller while it turns fast.
void showAircraftParts(osg::Group& aircraft, const simulation::AircraftParts& parts);

/// Returns the eye point of the pilot. Frame: the aircraft's.
glm::dvec3 pilotEyeInAircraft();

} // namespace scenery
