// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <osg/Node>
#include <osg/Vec4f>

namespace scenery
{

/// A single-engined high-wing aeroplane, 8.1 m long, 11 m span, 2.75 m high, made here of lofted sections: fuselage
/// with windows, strutted wing, tail, fixed gear and the blur of a turning propeller.
/// Frame: OpenSCENARIO's for vehicles: origin on the ground below the axle of the main wheels, x forward, y left,
/// z up; metres. `trim`: colour of stripe and tips, display values. Lit and hazed by the Atmosphere whose uniforms
/// stand above it.
osg::ref_ptr<osg::Node> makeLightAircraft(const osg::Vec4f& trim = {0.10F, 0.22F, 0.50F, 1.0F});

/// Where the pilot's eye is. Frame: the aircraft's.
glm::dvec3 pilotEyeInAircraft();

} // namespace scenery
