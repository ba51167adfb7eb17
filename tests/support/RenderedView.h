// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <osg/Group>
#include <osgSky/Atmosphere>

#include <osgOffscreen/OffscreenViewer>

#include "measurement/light/view/GreyBox.h"
#include "scenery/nodes/Pose.h"
#include "scenery/nodes/Sky.h"

namespace rendered
{

/// Sky and a flat grey ground, in an atmosphere; add what else is to be seen.
struct ViewScene
{
    explicit ViewScene(const osgSky::AtmosphereSettings& air = {})
        : atmosphere(new osgSky::Atmosphere(air)), root(new osg::Group)
    {
        root->setStateSet(atmosphere->stateSet());
        root->addChild(scenery::makeSky());
        root->addChild(measurement::greyPlain());
    }

    osg::ref_ptr<osgSky::Atmosphere> atmosphere;
    osg::ref_ptr<osg::Group> root;
};

inline osgOffscreen::OffscreenSettings smallPicture()
{
    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = 160;
    settings.heightPx = 120;
    return settings;
}

/// A picture of a scene from an eye, 40° high.
inline osg::ref_ptr<osg::Image> pictureFrom(osg::Node* scene, const scenery::Pose& eye,
                                            const osgOffscreen::OffscreenSettings& settings)
{
    auto made = osgOffscreen::OffscreenViewer::create(settings);
    if (!made)
    {
        ADD_FAILURE() << made.error().message();
        return new osg::Image;
    }
    osgOffscreen::OffscreenViewer& viewer = **made;
    viewer.viewer().setSceneData(scene);
    viewer.camera().setProjectionMatrixAsPerspective(
        40.0, static_cast<double>(settings.widthPx) / settings.heightPx, 0.5, 2e5);
    const glm::dmat4 view = scenery::viewFromWorld(eye);
    viewer.camera().setViewMatrix(osg::Matrixd(&view[0][0]));
    return viewer.picture();
}

} // namespace rendered
