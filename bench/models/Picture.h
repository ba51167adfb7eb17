// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>

#include <glm/glm.hpp>

#include <osgOffscreen/OffscreenViewer>

#include "scenery/nodes/Pose.h"

/// A camera. Frame: that of the scene. Units: metres, degrees.
struct View
{
    const char* name;
    glm::dvec3 eye, target;
    double heightDeg;
};

/// Draws a scene, 640 by 400 pixels with four samples; ends the program where that cannot be done.
inline osg::ref_ptr<osg::Image> pictureOf(osg::Node* scene, const View& view)
{
    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = 640;
    settings.heightPx = 400;
    settings.samples = 4;
    auto made = osgOffscreen::OffscreenViewer::create(settings);
    if (!made)
    {
        std::fprintf(stderr, "%s\n", made.error().message().c_str());
        std::exit(1);
    }
    osgOffscreen::OffscreenViewer& viewer = **made;
    viewer.viewer().setSceneData(scene);
    viewer.camera().setProjectionMatrixAsPerspective(view.heightDeg, 1.6, 0.3, 1e5);
    const glm::dmat4 matrix = scenery::viewFromWorld(scenery::poseLookingAt(view.eye, view.target));
    viewer.camera().setViewMatrix(osg::Matrixd(&matrix[0][0]));
    return viewer.picture();
}
