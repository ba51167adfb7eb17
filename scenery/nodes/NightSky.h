// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>

#include <osg/Group>
#include <osg/Vec3d>

#include "simulation/environment/NightSky.h"

namespace scenery
{

/// Stars and the moon, drawn behind the scene and before the clouds. Stars have the size, brightness and
/// colour that their magnitudes and colour indices ask for; the air near the horizon and moonlight dim them.
/// The moon has its phase, and is pale by day. Needs the uniforms of an Atmosphere above it. Threads: between
/// frames.
class NightSky
{
public:
    NightSky();

    /// A group; add it beside the sky.
    osg::Node& node() { return *_root; }

    /// `worldFromStars`: as simulation::worldFromStars() gives it.
    void show(const glm::dmat3& worldFromStars, double sunElevationDeg, const simulation::MoonSight& moon);

    /// The faintest magnitude that is seen overhead: less by a full moon (`moonlight` 1). It changes
    /// steadily, 0.62 a degree of the sun, from Venus alone at sunset to 6.5 at night.
    static double faintestSeen(double sunElevationDeg, double moonlight);

private:
    osg::ref_ptr<osg::Group> _root;
    osg::ref_ptr<osg::Node> _stars, _moon;
};

} // namespace scenery
