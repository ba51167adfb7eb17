// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Vec3f>

namespace osgSky
{

/// Computes the length of the way of the sun's light through the air, in units of the vertical one, from
/// `elevationDeg` above the horizon; below it, as at the horizon. Source: Kasten and Young, Revised optical
/// air mass tables and approximation formula (1989), equation 3.
double airMass(double elevationDeg);

/// Computes what share of the sun's light comes straight through clear air and haze, in bands about 610, 550
/// and 465 nm (red, green and blue of a screen). `haze`: the optical depth of the vertical haze in these
/// bands.
/// Sources: Bird and Riordan, Simple solar spectral model for direct and diffuse irradiance (1986), section
/// 2: Rayleigh scattering and ozone; their term for haze is replaced by what the visibility says, and water
/// vapour, which absorbs no visible light, is left out.
osg::Vec3f sunThroughAir(double elevationDeg, const osg::Vec3f& haze);

} // namespace osgSky
