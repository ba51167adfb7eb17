// SPDX-License-Identifier: Apache-2.0
#include <osgTraversal/CulledPart>

namespace osgTraversal
{

CulledPart::CulledPart(const osg::BoundingBox& bounds) : _bounds(bounds)
{
    setUseDisplayList(false);
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true);
    setUseVertexArrayObject(false);
    setDataVariance(osg::Object::STATIC);
}

} // namespace osgTraversal
