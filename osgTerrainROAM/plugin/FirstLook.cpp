// SPDX-License-Identifier: Apache-2.0
#include "FirstLook.h"

#include <osgViewer/View>

namespace osgTerrainROAM
{

bool FirstLook::handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter& action, osg::Object*,
                       osg::NodeVisitor*)
{
    if (_done || event.getEventType() != osgGA::GUIEventAdapter::FRAME) return false;
    _done = true;
    auto* const view = dynamic_cast<osgViewer::View*>(action.asView());
    if (!view) return false;
    const osg::Vec4 untouched(0.2f, 0.2f, 0.4f, 1.0f); // what osgViewer::View sets
    if (view->getCamera()->getClearColor() == untouched) view->getCamera()->setClearColor(_horizon);

    osgGA::CameraManipulator* const manipulator = view->getCameraManipulator();
    if (!manipulator || !manipulator->getAutoComputeHomePosition()) return false;
    const osg::Vec3d centre = _bounds.center();
    const double across = std::max(_bounds.xMax() - _bounds.xMin(), _bounds.yMax() - _bounds.yMin());
    manipulator->setHomePosition(centre + osg::Vec3d(0.0, -0.62, 0.30) * across, centre,
                                 osg::Vec3d(0.0, 0.0, 1.0));
    manipulator->home(event, action);
    return false;
}

} // namespace osgTerrainROAM
