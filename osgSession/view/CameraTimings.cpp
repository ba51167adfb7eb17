// SPDX-License-Identifier: Apache-2.0
#include "view/CameraTimings.h"

#include <vector>

#include <osg/Stats>

namespace trainer
{

namespace
{

std::vector<osg::Camera*> camerasOf(osgViewer::View& view)
{
    std::vector<osg::Camera*> cameras{view.getCamera()};
    for (unsigned int i = 0; i < view.getNumSlaves(); ++i)
        cameras.push_back(view.getSlave(i)._camera.get());
    return cameras;
}

} // namespace

void keepCameraTimings(osgViewer::View& view)
{
    for (osg::Camera* camera : camerasOf(view))
    {
        if (!camera->getStats()) camera->setStats(new osg::Stats("camera"));
        camera->getStats()->collectStats("rendering", true);
    }
}

CameraTimings cameraTimings(osgViewer::View& view, unsigned int frameNumber)
{
    CameraTimings timings;
    for (osg::Camera* camera : camerasOf(view))
    {
        double seconds = 0.0;
        if (!camera->getStats()) continue;
        if (camera->getStats()->getAttribute(frameNumber, "Cull traversal time taken", seconds))
            timings.cullMs += 1000.0 * seconds;
        if (camera->getStats()->getAttribute(frameNumber, "Draw traversal time taken", seconds))
            timings.drawMs += 1000.0 * seconds;
    }
    return timings;
}

} // namespace trainer
