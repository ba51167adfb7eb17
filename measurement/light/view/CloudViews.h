// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <foundation/Result.h>
#include <glm/vec3.hpp>

#include <osg/Group>
#include <osg/MatrixTransform>
#include <osgSky/Atmosphere>

#include <osgOffscreen/OffscreenViewer>

#include "scenery/nodes/Clouds.h"

namespace measurement
{

/// Small pictures of a layer of clouds by day, over a grey plain, with a ray for each pixel.
class CloudViews
{
public:
    /// `greyUnder`: how much greyer the whole sky is under a cover, as scenes have it (both 0 … 1). Errors:
    /// of the offscreen context.
    static foundation::Result<std::unique_ptr<CloudViews>> create(std::function<double(double)> greyUnder);

    /// One layer, from the plain on.
    void setLayer(const simulation::CloudLayer& layer);

    /// Returns how many eighths of what is overhead at 144 places of the plain is cloud, in the picture.
    double drawnOktas();

    /// Returns the height, in metres, at which clouds hide half of a black mast 1 km away from an eye at
    /// that height, seen before the sky: the base of an even layer. No number where they never do.
    double drawnBaseM();

    /// Returns the mean level, 0 … 255, of each of 201 pictures of an eye that climbs from 150 m below the
    /// base to 150 m above the top and looks ahead.
    std::vector<double> climb();

private:
    CloudViews(std::function<double(double)> greyUnder,
               std::unique_ptr<osgOffscreen::OffscreenViewer> viewer);

    osg::ref_ptr<osg::Image> look(const glm::dvec3& eye, const glm::dvec3& ahead, double highDeg);

    std::function<double(double)> _greyUnder;
    osg::ref_ptr<osgSky::Atmosphere> _atmosphere;
    osg::ref_ptr<osg::Group> _root;
    osg::ref_ptr<osg::MatrixTransform> _mast;
    scenery::Clouds _clouds;
    simulation::CloudLayer _layer;
    std::optional<osg::Vec3f> _sky; ///< colour of all of the sky; absent: the atmosphere's
    std::unique_ptr<osgOffscreen::OffscreenViewer> _viewer;
};

} // namespace measurement
