// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <glm/glm.hpp>

#include <osgSky/Atmosphere>

#include <osgOffscreen/OffscreenViewer>

namespace framebench
{

/// A view as the camera and the shaders need it.
struct Eye
{
    glm::dmat4 view{1.0}, projection{1.0};
};

/// The time of a frame, from the first traversal until the renderer has finished.
struct FrameCost
{
    double wallMs = 0.0;
    double cpuMs = 0.0; ///< of all threads of the process; least affected by other programs
};

/// An offscreen scene with sky and atmosphere that draws one node at a time in a look. It sets the uniforms
/// that RoamDrawable sets for its shader to the same values for all other nodes. Threads: one.
class Stage
{
public:
    /// `samples`: per pixel, as OffscreenSettings; `vertexStepM`: of the tile that is drawn. Errors: no such
    /// context.
    static foundation::Result<std::unique_ptr<Stage>> open(const osgOffscreen::OffscreenSettings& settings,
                                                           double vertexStepM);

    /// `look`: from lookState(); `withSky` false: black where there is no ground.
    void show(osg::Node* node, osg::StateSet* look, bool withSky = true);

    FrameCost draw(const Eye& eye);
    osg::ref_ptr<osg::Image> picture(const Eye& eye);

    const osgOffscreen::OffscreenSettings& settings() const { return _viewer->context().settings(); }
    const std::string& rendererName() const { return _viewer->context().rendererName(); }

private:
    Stage(std::unique_ptr<osgOffscreen::OffscreenViewer> viewer, double vertexStepM);
    void place(const Eye& eye);

    std::unique_ptr<osgOffscreen::OffscreenViewer> _viewer;
    const double _stepM;
    osg::ref_ptr<osgSky::Atmosphere> _atmosphere;
    osg::ref_ptr<osg::Group> _root = new osg::Group;
    osg::ref_ptr<osg::Group> _dressed = new osg::Group;
    osg::ref_ptr<osg::Node> _sky;
    osg::ref_ptr<osg::Uniform> _eye, _eyeSteps, _eyeRest, _step, _eyeWrapped, _eyeFromLocal, _worldFromLocal;
};

} // namespace framebench
