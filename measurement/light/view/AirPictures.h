// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <utility>

#include <foundation/Result.h>

#include <osg/Group>
#include <osg/Node>
#include <osgSky/Atmosphere>

#include <osgOffscreen/OffscreenViewer>

namespace measurement
{

/// What is looked at through air.
enum class SeenSurface
{
    ground, ///< of a terrain
    road,
    object,  ///< matt, as houses are
    aircraft ///< lacquered, as aircraft and cars are
};

/// Looks straight down on a level surface through air, and finds what of its contrast is left.
class AirPictures
{
public:
    /// Errors: of the offscreen context.
    static foundation::Result<std::unique_ptr<AirPictures>> create(SeenSurface surface);

    /// Returns what is left at a distance of the contrast of two surfaces that differ in light, 0 … 1: the
    /// difference of what is seen over that without air. Both are as bright as the picture shows best, for
    /// 8-bit levels tell no small difference; the air is as it is drawn, at this height of the sun, but as
    /// dense at every height as at its base, since the eye looks down.
    /// 24 pictures, and 48 for a new distance.
    double contrastLeft(double awayM, double visibilityM, double sunElevationDeg);

    /// Changes uniforms of the scene whenever the air is set: a fault for tests. Absent: none.
    void spoilBy(std::function<void(osg::StateSet& scene)> spoil) { _spoil = std::move(spoil); }

private:
    AirPictures(osg::Node* surface, std::unique_ptr<osgOffscreen::OffscreenViewer> viewer);

    double slope(double awayM, const osgSky::AtmosphereSettings& air, double mostLight);
    double lightSeen(double light);

    osg::ref_ptr<osg::Group> _root;
    osg::ref_ptr<osgSky::Atmosphere> _atmosphere;
    std::unique_ptr<osgOffscreen::OffscreenViewer> _viewer;
    std::map<double, double> _clear; ///< what is seen of more light without air, by distance
    std::function<void(osg::StateSet&)> _spoil;
};

} // namespace measurement
