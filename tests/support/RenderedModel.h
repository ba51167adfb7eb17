// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include <osg/BoundingSphere>
#include <osg/Node>

#include <osgOffscreen/OffscreenViewer>

namespace rendered
{

/// Where models are looked at from: above the eight corners of a box around them, so that no two sides look
/// alike.
inline const std::array<osg::Vec3d, 8> kModelDirections = {{{1.0, 0.7, 0.4},
                                                            {-0.9, 0.8, 0.5},
                                                            {0.7, -1.0, 0.3},
                                                            {-0.8, -0.7, 0.6},
                                                            {0.9, 0.6, -0.5},
                                                            {-0.7, 0.9, -0.4},
                                                            {0.8, -0.8, -0.6},
                                                            {-1.0, -0.6, -0.3}}};

/// Draws models by the light of a lamp at the eye, in one context.
class ModelStudio
{
public:
    /// Null, and a failed test, where there is no context.
    static std::unique_ptr<ModelStudio> open(int widthPx = 640, int heightPx = 480)
    {
        auto made = osgOffscreen::OffscreenViewer::create({.widthPx = widthPx, .heightPx = heightPx});
        if (made) return std::unique_ptr<ModelStudio>(new ModelStudio(std::move(*made), widthPx, heightPx));
        ADD_FAILURE() << made.error().message();
        return nullptr;
    }

    /// One picture for each direction, filled by a ball around the model.
    std::vector<osg::ref_ptr<osg::Image>> pictures(osg::Node& model, const osg::BoundingSphere& ball)
    {
        _viewer->viewer().setSceneData(&model);
        std::vector<osg::ref_ptr<osg::Image>> pictures;
        // What the model does not set, OpenGL's current colour, is what drawing it leaves, once it has been
        // seen.
        pictureTowards(kModelDirections.front(), ball);
        for (const osg::Vec3d& towards : kModelDirections)
            pictures.push_back(pictureTowards(towards, ball));
        return pictures;
    }

private:
    osg::ref_ptr<osg::Image> pictureTowards(osg::Vec3d direction, const osg::BoundingSphere& ball)
    {
        direction.normalize();
        const double away = ball.radius() / std::sin(osg::DegreesToRadians(15.0));
        _viewer->camera().setProjectionMatrixAsPerspective(30.0, _aspect, away - 1.1 * ball.radius(),
                                                           away + 1.1 * ball.radius());
        _viewer->camera().setViewMatrixAsLookAt(ball.center() + direction * away, ball.center(),
                                                {0.0, 0.0, 1.0});
        return _viewer->picture();
    }

    ModelStudio(std::unique_ptr<osgOffscreen::OffscreenViewer> viewer, int widthPx, int heightPx)
        : _viewer(std::move(viewer)), _aspect(static_cast<double>(widthPx) / heightPx)
    {
        _viewer->camera().setClearColor({0.35F, 0.45F, 0.6F, 1.0F});
    }

    std::unique_ptr<osgOffscreen::OffscreenViewer> _viewer;
    double _aspect;
};

} // namespace rendered
