// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <osg/Node>
#include <osg/Vec4f>

namespace scenery
{

/// Makes a single-engined high-wing aeroplane of lofted sections, 8.1 m long, 11 m span, 2.75 m high: fuselage with
/// windows, strutted wing, tail, fixed gear and the blur of a turning propeller.
/// Frame: as OpenSCENARIO vehicles: origin on the ground below the axle of the main wheels, x forward, y left, z up;
/// metres. `trim`: colour of stripe and tips, display values. Needs the uniforms of an Atmosphere above it in the
/// graph.
osg::ref_ptr<osg::Node> makeLightAircraft(const osg::Vec4f& trim = {0.10F, 0.22F, 0.50F, 1.0F});

/// Returns the eye point of the pilot. Frame: the aircraft's.
glm::dvec3 pilotEyeInAircraft();

} // namespace scenery
