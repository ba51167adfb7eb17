// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Vec3f>

namespace osgSky
{

/// The sky of clear air at one height of the sun, as it is shown. Units: degrees; linear radiance.
struct SkyKey
{
    double elevationDeg;
    osg::Vec3f zenith, horizon, glow;
};

/// Returns the sky for a height of the sun. In the dark it is brighter than in nature, as an eye sees it that
/// is used to the dark; a picture of it changes by the same step for each degree up to 15.
SkyKey skyAt(double elevationDeg);

} // namespace osgSky
