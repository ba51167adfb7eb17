// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgViewer/View>

#include <osgTerrainROAM/FirstLook>
#include <osgTerrainROAM/RoamTerrain>

namespace osgTerrainROAM
{

namespace
{

void setBackground(osg::Camera& camera, const RoamTerrain& terrain)
{
    const osg::Vec4 untouched(0.2f, 0.2f, 0.4f, 1.0f); // what osgViewer::View sets
    if (!terrain.atmosphere() || camera.getClearColor() != untouched) return;
    const osgSky::AtmosphereLight& light = terrain.atmosphere()->light();
    camera.setClearColor(osg::Vec4(osgSky::displayColour(light.horizon, light.exposure), 1.0f));
}

} // namespace

bool FirstLook::handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter& action,
                       osg::Object* object, osg::NodeVisitor*)
{
    if (_done || event.getEventType() != osgGA::GUIEventAdapter::FRAME) return false;
    _done = true;
    auto* const view = dynamic_cast<osgViewer::View*>(action.asView());
    const auto* const terrain = dynamic_cast<const RoamTerrain*>(object);
    if (!view || !terrain || !terrain->drawable()) return false;
    setBackground(*view->getCamera(), *terrain);

    osgGA::CameraManipulator* const manipulator = view->getCameraManipulator();
    if (!manipulator || !manipulator->getAutoComputeHomePosition()) return false;
    const osg::BoundingBox& bounds = terrain->drawable()->getBoundingBox();
    const osg::Vec3d centre = bounds.center();
    const double across = std::max(bounds.xMax() - bounds.xMin(), bounds.yMax() - bounds.yMin());
    manipulator->setHomePosition(centre + osg::Vec3d(0.0, -0.62, 0.30) * across, centre,
                                 osg::Vec3d(0.0, 0.0, 1.0));
    manipulator->home(event, action);
    return false;
}

} // namespace osgTerrainROAM
