// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/BoundingBox>
#include <osg/Vec4f>
#include <osgGA/GUIEventHandler>

namespace osgTerrainROAM
{

/// Turns the first look of a viewer that has no opinion of its own onto the terrain: from the south and above.
/// OSG's own home position looks level at the middle of the bounding sphere, which shows land from its edge.
/// Acts once, with the first frame event, and only on a manipulator that computes its home position itself; the
/// background becomes the horizon's colour where it is still OSG's blue.
class FirstLook : public osgGA::GUIEventHandler
{
public:
    FirstLook(const osg::BoundingBox& bounds, const osg::Vec4f& horizon) : _bounds(bounds), _horizon(horizon)
    {
    }

    bool handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter& action, osg::Object* object,
                osg::NodeVisitor* visitor) override;

protected:
    ~FirstLook() override = default;

private:
    osg::BoundingBox _bounds;
    osg::Vec4f _horizon;
    bool _done = false;
};

} // namespace osgTerrainROAM
