// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <foundation/Result.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <osg/Group>
#include <osg/Image>
#include <osgSky/Atmosphere>

#include <osgOffscreen/OffscreenViewer>

#include "scenery/nodes/LightPoints.h"

namespace measurement
{

/// What the eye of a night is: 8e-7 lx.
inline constexpr double kNightLx = 8e-7;

/// The shares of groups of lamps that are all on in full.
scenery::LightLevels fullLevels();

/// How lamps are looked at.
struct LampSight
{
    glm::dvec3 eye{-1000.0, 0.0, 0.0};
    double visibilityM = 60000.0;
    double leastLx = kNightLx; ///< what the eye just sees
    double timeS = 0.0;
    glm::dvec2 asidePx{0.0}; ///< how far the first lamp stands off the middle of the picture
    scenery::LightLevels levels = fullLevels();
};

/// Pictures of lamps before black, 32 by 32 pixels and 4 degrees high, by an eye that looks at the first one.
class LampPictures
{
public:
    static constexpr int kSidePx = 32;

    /// `lights`: one or more. `samples`: of a pixel. Errors: of the offscreen context.
    static foundation::Result<std::unique_ptr<LampPictures>>
    create(const std::vector<scenery::LightPoint>& lights, int samples = 1);

    osg::ref_ptr<osg::Image> picture(const LampSight& sight);

    /// Changes uniforms of the scene before each picture: a fault for tests. Absent: none.
    void spoilBy(std::function<void(osg::StateSet& scene)> spoil) { _spoil = std::move(spoil); }

private:
    LampPictures(const std::vector<scenery::LightPoint>& lights,
                 std::unique_ptr<osgOffscreen::OffscreenViewer> viewer);

    osg::ref_ptr<osgSky::Atmosphere> _atmosphere;
    osg::ref_ptr<osg::Group> _root;
    glm::dvec3 _at;
    scenery::LightUniforms _uniforms;
    scenery::LightPoints _points;
    std::unique_ptr<osgOffscreen::OffscreenViewer> _viewer;
    std::function<void(osg::StateSet&)> _spoil;
};

/// The highest level of a picture in a channel, 0 … 255.
int brightestLevel(const osg::Image& image, int channel = 1);

/// The sum over all pixels of a channel in linear light times the exposure: undoes displayColour().
double lightIn(const osg::Image& image, int channel = 1);

/// The distance from which a lamp shows in its pictures, by halving; metres, within 0.4 %.
double rangeInPictureM(LampPictures& lamps, double visibilityM, double leastLx);

/// Least and greatest over mean of what `measure` finds in pictures with the lamp at 64 places in a pixel.
std::array<double, 2> spreadOverPlaces(LampPictures& lamps,
                                       const std::function<double(const osg::Image&)>& measure);

/// Where the light of a unit that tells angles changes its colour.
struct ColourChange
{
    double middleDeg = 0.0; ///< above the horizon
    double widthDeg = 0.0;  ///< from 2 to 98 % of white
};

/// Looks for it in pictures of a unit that shines towards -x, from 6 km, within 0.2 degrees about
/// `expectedDeg`.
ColourChange colourChange(LampPictures& unit, double expectedDeg);

} // namespace measurement
