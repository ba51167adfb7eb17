// SPDX-License-Identifier: Apache-2.0
#include "HandCull.h"

#include <osg/TriangleFunctor>
#include <osgUtil/CullVisitor>

namespace handcull
{

namespace
{

struct TriangleCount
{
    std::uint64_t count = 0;
    void operator()(const osg::Vec3&, const osg::Vec3&, const osg::Vec3&, bool = false) { ++count; }
};

void collect(const osgUtil::StateGraph& graph, std::vector<osg::ref_ptr<osg::Drawable>>& drawables)
{
    for (const auto& leaf : graph._leaves)
        drawables.push_back(leaf->_drawable);
    for (const auto& [stateSet, child] : graph._children)
        collect(*child, drawables);
}

} // namespace

osg::ref_ptr<osg::Camera> cameraAt(const osg::Vec3d& eye, const osg::Vec3d& target)
{
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setViewport(0, 0, 800, 600);
    camera->setViewMatrixAsLookAt(eye, target, osg::Vec3d(0, 0, 1));
    camera->setProjectionMatrixAsPerspective(46.8, 800.0 / 600.0, 1.0, 1.0e6);
    return camera;
}

std::uint64_t Culled::triangles() const
{
    osg::TriangleFunctor<TriangleCount> functor;
    for (const auto& drawable : drawables)
        if (drawable->supports(functor)) drawable->accept(functor);
    return functor.count;
}

Culled cull(osg::Node& scene, osg::Camera& camera, unsigned int frame, bool computeNearFar,
            double simulationTimeS)
{
    const osg::ref_ptr<osgUtil::CullVisitor> visitor = osgUtil::CullVisitor::create();
    const osg::ref_ptr<osgUtil::StateGraph> graph = new osgUtil::StateGraph;
    const osg::ref_ptr<osgUtil::RenderStage> stage = new osgUtil::RenderStage;
    const osg::ref_ptr<osg::FrameStamp> stamp = new osg::FrameStamp;
    stamp->setFrameNumber(frame);
    stamp->setSimulationTime(simulationTimeS);
    stage->setCamera(&camera);
    stage->setViewport(camera.getViewport());
    visitor->setFrameStamp(stamp);
    visitor->setTraversalNumber(frame);
    visitor->setComputeNearFarMode(computeNearFar ? osg::CullSettings::COMPUTE_NEAR_FAR_USING_BOUNDING_VOLUMES
                                                  : osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    visitor->setStateGraph(graph);
    visitor->setRenderStage(stage);
    visitor->pushViewport(camera.getViewport());
    const osg::ref_ptr<osg::RefMatrix> projection = new osg::RefMatrix(camera.getProjectionMatrix());
    visitor->pushProjectionMatrix(projection);
    visitor->pushModelViewMatrix(new osg::RefMatrix(camera.getViewMatrix()), osg::Transform::ABSOLUTE_RF);
    scene.accept(*visitor);
    visitor->popModelViewMatrix();
    visitor->popProjectionMatrix();
    visitor->popViewport();

    Culled culled;
    culled.projection = *projection;
    collect(*graph, culled.drawables);
    return culled;
}

} // namespace handcull
