// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <osgOffscreen/OffscreenViewer>

#include "RenderedView.h"
#include "scenery/models/entities/DefaultSize.h"
#include "scenery/nodes/InteriorNode.h"

/// What the tests of interiors share.
namespace seat
{

inline const glm::dvec3 kEyeOfCar(1.2, 0.36, 1.2), kEyeOfAircraft(0.45, 0.27, 1.75);

inline scenery::models::InteriorModel interiorOf(scenery::models::EntityKind kind, const glm::dvec3& eye)
{
    scenery::models::EntityShape shape;
    shape.kind = kind;
    scenery::models::setDefaultSize(shape);
    return *scenery::models::makeInterior(shape, eye);
}

/// The panel of an interior straight before a camera, or the whole from its eye.
class InteriorStudio
{
public:
    InteriorStudio(scenery::models::EntityKind kind, const glm::dvec3& eye, int width, int height,
                   const osgSky::AtmosphereSettings& air = {})
        : scene(air), interior(interiorOf(kind, eye)), widePx(width), highPx(height)
    {
        scene.root->addChild(interior.node());
        if (interior.disc()) scene.root->addChild(interior.disc());
        auto made =
            osgOffscreen::OffscreenViewer::create({.widthPx = widePx, .heightPx = highPx, .samples = 4});
        if (!made) return;
        viewer = std::move(*made);
        viewer->viewer().setSceneData(scene.root);
    }

    osg::ref_ptr<osg::Image> picture(const scenery::Pose& eye, double highDeg)
    {
        viewer->camera().setProjectionMatrixAsPerspective(highDeg, static_cast<double>(widePx) / highPx, 0.05,
                                                          2e4);
        const glm::dmat4 view = scenery::viewFromWorld(eye);
        viewer->camera().setViewMatrix(osg::Matrixd(&view[0][0]));
        return viewer->picture();
    }

    /// Where a point of the scene lies in the last picture. Units: pixels from its lower left corner.
    glm::dvec2 pixelOf(const glm::dvec3& world) const
    {
        const osg::Vec3d seen = osg::Vec3d(world.x, world.y, world.z) * viewer->camera().getViewMatrix() *
                                viewer->camera().getProjectionMatrix();
        return {0.5 * (seen.x() + 1.0) * widePx, 0.5 * (seen.y() + 1.0) * highPx};
    }

    /// Hides the part of a name, or shows it again, until the next show().
    void mask(const std::string& name, bool isShown)
    {
        for (unsigned i = 0; i < interior.node()->asGroup()->getNumChildren(); ++i)
            if (osg::Node& part = *interior.node()->asGroup()->getChild(i); part.getName() == name)
                part.setNodeMask(isShown ? ~0U : 0U);
    }

    rendered::ViewScene scene;
    scenery::InteriorNode interior;
    int widePx, highPx;
    std::unique_ptr<osgOffscreen::OffscreenViewer> viewer;
};

} // namespace seat
