// SPDX-License-Identifier: Apache-2.0
#include "Stage.h"

#include <chrono>
#include <cmath>

#include <osg/Light>
#include <osg/LightSource>

#include "measurement/ProcessorTime.h"
#include "scenery/nodes/Sky.h"

namespace framebench
{

namespace
{

/// The period of wrapped positions, the same as in RoamDrawable's draw.
constexpr double kWrapM = 4096.0;

/// Waits at the swap until the renderer has finished the frame, so that the time of a frame includes the
/// drawing.
struct FinishAtSwap : public osg::GraphicsContext::SwapCallback
{
    void swapBuffersImplementation(osg::GraphicsContext* context) override
    {
        context->swapBuffersImplementation();
        glFinish();
    }
};

double wallMs()
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

osg::Matrixd toOsg(const glm::dmat4& matrix)
{
    return osg::Matrixd(&matrix[0][0]);
}

osg::Matrix3 rotationOf(const osg::Matrixd& m)
{
    osg::Matrix3 rotation;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            rotation(row, column) = static_cast<float>(m(row, column));
    return rotation;
}

osg::ref_ptr<osg::Uniform> added(osg::StateSet& state, const char* name, osg::Uniform::Type type)
{
    osg::ref_ptr<osg::Uniform> uniform = new osg::Uniform(type, name);
    uniform->setDataVariance(osg::Object::DYNAMIC);
    state.addUniform(uniform);
    return uniform;
}

} // namespace

foundation::Result<std::unique_ptr<Stage>> Stage::open(const osgOffscreen::OffscreenSettings& settings,
                                                       double vertexStepM)
{
    auto viewer = osgOffscreen::OffscreenViewer::create(settings);
    if (!viewer) return viewer.error();
    return std::unique_ptr<Stage>(new Stage(std::move(*viewer), vertexStepM));
}

Stage::Stage(std::unique_ptr<osgOffscreen::OffscreenViewer> viewer, double vertexStepM)
    : _viewer(std::move(viewer)),
      _stepM(vertexStepM),
      _atmosphere(new osgSky::Atmosphere),
      _sky(scenery::makeSky())
{
    osg::StateSet& state = *_root->getOrCreateStateSet();
    _atmosphere->addUniformsTo(state);
    _eye = added(state, "benchEye", osg::Uniform::FLOAT_VEC3);
    _eyeSteps = added(state, "terrainEyeSteps", osg::Uniform::INT_VEC3);
    _eyeRest = added(state, "terrainEyeRest", osg::Uniform::FLOAT_VEC3);
    _step = added(state, "terrainStep", osg::Uniform::FLOAT);
    _eyeWrapped = added(state, "terrainEyeWrapped", osg::Uniform::FLOAT_VEC3);
    _eyeFromLocal = added(state, "terrainEyeFromLocal", osg::Uniform::FLOAT_MAT3);
    _worldFromLocal = added(state, "terrainWorldFromLocal", osg::Uniform::FLOAT_MAT3);
    _root->addChild(_sky);
    _root->addChild(_dressed);
    _viewer->viewer().setSceneData(_root);
    _viewer->viewer().setLightingMode(osg::View::SKY_LIGHT);
    _atmosphere->applyTo(*_viewer->viewer().getLight());
    _viewer->camera().setClearColor({0.0F, 0.0F, 0.0F, 1.0F});
    _viewer->context().setSwapCallback(new FinishAtSwap);
}

void Stage::show(osg::Node* node, osg::StateSet* look, bool withSky)
{
    _dressed->removeChildren(0, _dressed->getNumChildren());
    _dressed->addChild(node);
    _dressed->setStateSet(look);
    _sky->setNodeMask(withSky ? ~0U : 0U);
}

void Stage::place(const Eye& eye)
{
    const osg::Matrixd view = toOsg(eye.view);
    _viewer->camera().setViewMatrix(view);
    _viewer->camera().setProjectionMatrix(toOsg(eye.projection));
    osg::Matrixd inverse;
    inverse.invert(view);
    const osg::Vec3d place = inverse.getTrans();
    osg::Vec3f wrapped, rest;
    int steps[3];
    for (int i = 0; i < 3; ++i)
    {
        wrapped[i] = static_cast<float>(place[i] - kWrapM * std::floor(place[i] / kWrapM));
        steps[i] = static_cast<int>(std::round(place[i] / _stepM));
        rest[i] = static_cast<float>(place[i] - steps[i] * _stepM);
    }
    _eye->set(osg::Vec3f(place));
    _eyeSteps->set(steps[0], steps[1], steps[2]);
    _eyeRest->set(rest);
    _step->set(static_cast<float>(_stepM));
    _eyeWrapped->set(wrapped);
    _eyeFromLocal->set(rotationOf(view));
    _worldFromLocal->set(rotationOf(view * inverse));
}

FrameCost Stage::draw(const Eye& eye)
{
    place(eye);
    const double wall = wallMs(), cpu = measurement::processorMs();
    _viewer->frame(0.0);
    return {wallMs() - wall, measurement::processorMs() - cpu};
}

osg::ref_ptr<osg::Image> Stage::picture(const Eye& eye)
{
    place(eye);
    return _viewer->picture();
}

} // namespace framebench
