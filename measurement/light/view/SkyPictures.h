// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <foundation/Result.h>
#include <glm/vec3.hpp>

#include <osg/Group>
#include <osgSky/Atmosphere>

#include <osgOffscreen/OffscreenViewer>

namespace measurement
{

/// What a view shows at each step of a sweep.
struct SkySweep
{
    std::vector<double> levels; ///< mean luminance of the sky as it is shown, 0 … 1
    std::vector<double> lights; ///< the light that this level stands for, without the exposure
};

/// Small pictures of the sky over a grey plain.
class SkyPictures
{
public:
    static constexpr int kSteps = 200;

    /// Errors: of the offscreen context.
    static foundation::Result<std::unique_ptr<SkyPictures>> create();

    /// Looks along a direction from 50 m above the plain, at each of 201 settings from share 0 to 1 of a
    /// sweep; the upper half of the picture is measured.
    SkySweep sweep(const std::function<osgSky::AtmosphereSettings(double share)>& settingsAt,
                   const glm::dvec3& towards);

private:
    explicit SkyPictures(std::unique_ptr<osgOffscreen::OffscreenViewer> viewer);

    osg::ref_ptr<osgSky::Atmosphere> _atmosphere;
    osg::ref_ptr<osg::Group> _root;
    std::unique_ptr<osgOffscreen::OffscreenViewer> _viewer;
};

/// The largest change from one level to the next; no number where a level is none.
double largestStep(const std::vector<double>& levels);

/// The deepest fall below what has been before, as a share of it, between two shares of a sweep.
double deepestFall(const std::vector<double>& levels, double fromShare, double toShare);

/// Sweeps of the sun's height, -20 to 90 degrees, and where in one a height stands.
osgSky::AtmosphereSettings sunAtShare(double share);
double shareOfSun(double elevationDeg);

} // namespace measurement
