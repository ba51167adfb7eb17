// SPDX-License-Identifier: Apache-2.0
// A progressive object that switches from one level to another, in captured frames.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <osg/BlendFunc>
#include <osg/Material>

#include <osgPMObjects/core/simplify/Simplify.h>

#include <osgOffscreen/OffscreenViewer>
#include <osgPMObjects/ProgressiveNode>

#include "ClosedMeshes.h"
#include "RenderedKeep.h"
#include "SimplifyMeshes.h"

namespace switched
{

using namespace osgPMObjects;
using rendered::keep;
using Picture = osg::ref_ptr<osg::Image>;

inline constexpr double kFrameS = 1.0 / 60.0;

/// A torus on a sheet of another colour, or of glass.
inline osg::ref_ptr<ProgressiveShape> torusOnSheet(bool isOfGlass = false)
{
    core::Mesh mesh = testsupport::lit(
        testsupport::together(testsupport::torus(48, 30), testsupport::waves(30, 24), {-15.0, -12.0, -2.0}));
    std::vector<osg::ref_ptr<osg::StateSet>> states;
    for (core::Material& material : mesh.materials)
    {
        const osg::ref_ptr<osg::Material> paint = new osg::Material;
        paint->setDiffuse(osg::Material::FRONT_AND_BACK, states.empty() ? osg::Vec4(0.9F, 0.4F, 0.2F, 1.0F)
                                                                        : osg::Vec4(0.3F, 0.7F, 0.4F, 1.0F));
        material.state = static_cast<std::uint32_t>(states.size());
        states.push_back(new osg::StateSet);
        states.back()->setAttributeAndModes(paint);
        if (!isOfGlass || states.size() == 1) continue;
        material.isTransparent = true;
        paint->setAlpha(osg::Material::FRONT_AND_BACK, 0.5F);
        states.back()->setAttributeAndModes(new osg::BlendFunc);
        states.back()->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    }
    return new ProgressiveShape(core::buildProgressiveMesh(mesh, core::simplify(mesh)), states);
}

inline const osg::ref_ptr<ProgressiveShape>& made()
{
    static const osg::ref_ptr<ProgressiveShape> shape = torusOnSheet();
    return shape;
}

/// Settings that always choose the level after so many steps.
inline core::SelectionSettings always(std::uint32_t steps)
{
    core::SelectionSettings settings;
    settings.method = core::SelectionMethod::ranges;
    settings.ranges.steps = {steps};
    return settings;
}

inline core::SwitchSettings by(core::SwitchMethod method,
                               core::BlendProfile profile = core::BlendProfile::over, float durationS = 0.5F)
{
    return {method, profile, durationS, 0.0F};
}

/// Averages squares of `factor` × `factor` pixels, RGB.
inline Picture shrunk(const osg::Image& picture, int factor)
{
    Picture small = new osg::Image;
    small->allocateImage(picture.s() / factor, picture.t() / factor, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (int y = 0; y < small->t(); ++y)
        for (int x = 0; x < small->s(); ++x)
            for (int channel = 0; channel < 3; ++channel)
            {
                int sum = 0;
                for (int i = 0; i < factor * factor; ++i)
                    sum += picture.data(x * factor + i % factor, y * factor + i / factor)[channel];
                small->data(x, y)[channel] =
                    static_cast<unsigned char>((sum + factor * factor / 2) / (factor * factor));
            }
    return small;
}

/// The difference of two images.
struct Change
{
    double mean = 0.0; ///< over pixels and channels, of 255
    int largest = 0;   ///< of one pixel in one channel
};

inline Change changeBetween(const osg::Image& a, const osg::Image& b)
{
    Change change;
    long sum = 0;
    for (int y = 0; y < a.t(); ++y)
        for (int x = 0; x < a.s(); ++x)
            for (int channel = 0; channel < 3; ++channel)
            {
                const int step = std::abs(a.data(x, y)[channel] - b.data(x, y)[channel]);
                sum += step;
                change.largest = std::max(change.largest, step);
            }
    change.mean = static_cast<double>(sum) / (3.0 * a.s() * a.t());
    return change;
}

inline Change worst(const Change& a, const Change& b)
{
    return {std::max(a.mean, b.mean), std::max(a.largest, b.largest)};
}

/// Captures frames of a scene, one after the other; each pixel of an image is the mean of `samples` ×
/// `samples`.
class Stage
{
public:
    static std::unique_ptr<Stage> of(osg::Node& scene, int samples = 1, int widthPx = 200, int heightPx = 150)
    {
        auto made = osgOffscreen::OffscreenViewer::create(
            {.widthPx = widthPx * samples, .heightPx = heightPx * samples});
        if (!made)
        {
            ADD_FAILURE() << made.error().message();
            return nullptr;
        }
        std::unique_ptr<Stage> stage(new Stage(std::move(*made), samples));
        stage->_viewer->viewer().setSceneData(&scene);
        stage->_viewer->camera().setClearColor({0.35F, 0.45F, 0.6F, 1.0F});
        return stage;
    }

    /// Looks from a side, at a distance where the sphere fills so much of the image's height.
    void lookAt(const osg::BoundingSphere& ball, double share = 1.0, osg::Vec3d from = {0.6, -1.0, 0.7})
    {
        from.normalize();
        const double away = ball.radius() / std::sin(osg::DegreesToRadians(15.0)) / share;
        const double half = 1.2 * ball.radius();
        _viewer->camera().setProjectionMatrixAsPerspective(
            30.0, 4.0 / 3.0, std::max(0.1 * away, away - 2.0 * half), away + 3.0 * half);
        _viewer->camera().setViewMatrixAsLookAt(osg::Vec3d(ball.center()) + from * away, ball.center(),
                                                {0.0, 0.0, 1.0});
    }

    osg::Camera& camera() { return _viewer->camera(); }

    /// Only the lights of the scene are on, no headlight.
    void turnOffHeadlight() { _viewer->viewer().setLightingMode(osg::View::NO_LIGHT); }

    /// Advances the time by so much and renders a frame.
    Picture after(double seconds)
    {
        _timeS += seconds;
        const Picture picture = _viewer->picture(_timeS);
        return _samples == 1 ? picture : shrunk(*picture, _samples);
    }

private:
    Stage(std::unique_ptr<osgOffscreen::OffscreenViewer> viewer, int samples)
        : _viewer(std::move(viewer)), _samples(samples)
    {
    }

    std::unique_ptr<osgOffscreen::OffscreenViewer> _viewer;
    int _samples;
    double _timeS = 1.0;
};

} // namespace switched
