// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osg/Group>
#include <osg/Image>
#include <osg/Program>
#include <osg/StateSet>
#include <osg/Vec2d>
#include <osg/Vec3d>
#include <osg/Vec3f>

#include "scenery/clouds/CloudVolume.h"

namespace scenery
{

/// Layers of clouds as bodies, seen from below, above and within, and their shadow on what lies below.
/// Rays go through the layers at a part of the pixels, into a picture of their own before anything else is
/// drawn; behind the sky that picture is laid over the scene. An eye below the lowest base sees them behind
/// everything else; from higher up what is nearer hides them. They are the same in every picture of an equal
/// state. Needs the uniforms of an Atmosphere above it.
/// Frame: world, local east-north-up. Units: metres. Threads: between frames.
class Clouds
{
public:
    Clouds();

    /// A group; add it beside the sky.
    osg::Node& node() { return *_root; }

    /// Replaces the layers, sorted by base, kMostCloudLayers at most; their heights count from `groundM`.
    /// Cost: about 0.3 s each.
    void setLayers(const std::vector<simulation::CloudLayer>& layers, double groundM);
    const std::vector<simulation::CloudLayer>& layers() const { return _layers; }

    /// `sunLight`: irradiance of what faces the sun above the clouds. `driftM`: how far wind has carried
    /// them. Light within the clouds is computed anew when the sun has moved by a degree.
    void show(const osg::Vec3d& towardsSun, const osg::Vec3f& sunLight, const osg::Vec2d& driftM);

    /// How many pixels along a side share a ray, 1 … 16, and the most steps of a ray, 8 … 128.
    void setDetail(int pixelsPerRay, int steps);

    /// Sets what shaders of the ground need to know of the shadow; with layers there is a define, too.
    void shadeBy(osg::StateSet& below);

    /// How much of the shadow counts, 0 … 1: less where the sun is weakened everywhere, as under a full
    /// cover.
    void setShadowStrength(double strength);

    /// The share of the sky that they cover, as an eye at a height sees it from below: less the higher it is
    /// in or above them. 0 … 1.
    double coverAbove(double eyeM) const;

private:
    void updateLight(const osg::Vec3d& towardsSun);

    std::vector<simulation::CloudLayer> _layers;
    std::vector<clouds::CloudVolume> _volumes;
    double _groundM = 0.0;
    osg::Vec3d _litFrom{0.0, 0.0, 0.0};
    osg::ref_ptr<osg::Group> _root;
    osg::ref_ptr<osg::Node> _march, _laidBehind, _laidAmong;
    osg::ref_ptr<osg::Image> _volumeImage, _shadeImage;
    osg::ref_ptr<osg::StateSet> _below;
};

/// Makes the program that lays the picture of the clouds over the scene: behind all things for an eye below
/// the clouds, else among them by depth.
osg::ref_ptr<osg::Program> makeCloudSheetProgram(bool isAmong);

} // namespace scenery
