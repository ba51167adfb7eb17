// SPDX-License-Identifier: Apache-2.0
#include <osgUtil/CullVisitor>

#include <osgTraversal/CulledDrawable>

namespace osgTraversal
{

CulledDrawable::CulledDrawable()
{
    setUseDisplayList(false);
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true);
}

CulledDrawable::CulledDrawable(const CulledDrawable& other, const osg::CopyOp& copyOp)
    : osg::Drawable(other, copyOp)
{
}

void CulledDrawable::accept(osg::NodeVisitor& visitor)
{
    osgUtil::CullVisitor* cullVisitor = visitor.asCullVisitor();
    if (!cullVisitor) return osg::Drawable::accept(visitor);
    if (!hasSurface() || !visitor.validNodeMask(*this)) return;
    visitor.pushOntoNodePath(this);
    cull(*cullVisitor);
    visitor.popFromNodePath();
}

} // namespace osgTraversal
