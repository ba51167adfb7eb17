// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <osgOffscreen/OffscreenViewer>

#include "RenderedScene.h"

namespace rendered
{

/// The backends this build has.
inline std::vector<osgOffscreen::Backend> backends()
{
    std::vector<osgOffscreen::Backend> list;
    for (const auto backend : {osgOffscreen::Backend::osmesa, osgOffscreen::Backend::egl})
        if (osgOffscreen::isAvailable(backend)) list.push_back(backend);
    return list;
}

/// An offscreen viewer set up on a scene made for it, or a failed test.
inline std::unique_ptr<osgOffscreen::OffscreenViewer>
viewerOf(osg::Node* scene, const osgOffscreen::OffscreenSettings& settings)
{
    auto made = osgOffscreen::OffscreenViewer::create(settings);
    if (!made)
    {
        ADD_FAILURE() << made.error().message();
        return nullptr;
    }
    std::unique_ptr<osgOffscreen::OffscreenViewer> viewer = std::move(*made);
    viewer->viewer().setSceneData(scene);
    viewer->camera().setClearColor({0.6F, 0.7F, 0.8F, 1.0F});
    viewer->camera().setViewMatrixAsLookAt({0.0, -10.0, 2.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0});
    return viewer;
}

/// One picture of the small scene, in a context of its own.
inline osg::ref_ptr<osg::Image> pictureOf(const SceneOptions& scene,
                                          const osgOffscreen::OffscreenSettings& settings)
{
    const auto viewer = viewerOf(smallScene(scene), settings);
    return viewer ? viewer->picture() : nullptr;
}

} // namespace rendered
