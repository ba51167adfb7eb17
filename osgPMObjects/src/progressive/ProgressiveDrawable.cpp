// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgUtil/CullVisitor>

#include <osgPMObjects/ProgressiveDrawable>

#include "ViewLevelTable.h"

namespace osgPMObjects
{

ProgressiveDrawable::ProgressiveDrawable() : ProgressiveDrawable(nullptr) {}

ProgressiveDrawable::ProgressiveDrawable(osg::ref_ptr<const ProgressiveShape> shape)
    : _shape(shape), _views(std::make_unique<ViewLevelTable>(_shape))
{
    setUseDisplayList(false);
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true);
}

ProgressiveDrawable::ProgressiveDrawable(const ProgressiveDrawable& other, const osg::CopyOp& copyOp)
    : osg::Drawable(other, copyOp),
      _shape(other._shape),
      _views(std::make_unique<ViewLevelTable>(_shape)),
      _steps(other._steps)
{
}

ProgressiveDrawable::~ProgressiveDrawable() = default;

core::Selection ProgressiveDrawable::fixedLevel() const
{
    return {std::min(_steps, _shape->progressive().stepCount)};
}

void ProgressiveDrawable::accept(osg::NodeVisitor& visitor)
{
    osgUtil::CullVisitor* const cullVisitor = visitor.asCullVisitor();
    if (!cullVisitor) return osg::Drawable::accept(visitor);
    if (_shape) cull(*cullVisitor, [this](const CullView&, core::HeldLevel&) { return fixedLevel(); }, {});
}

void ProgressiveDrawable::cull(osgUtil::CullVisitor& visitor, const Choice& choice,
                               const Switching& switching)
{
    if (!_shape || !visitor.validNodeMask(*this)) return;
    if (isCullingActive() && visitor.isCulled(getBoundingBox())) return;
    visitor.pushOntoNodePath(this);
    if (getStateSet()) visitor.pushStateSet(getStateSet());
    cullLevels(visitor, *_shape, _views->find(cullViewOf(visitor), choice, switching), switching.isShaded);
    if (getStateSet()) visitor.popStateSet();
    visitor.popFromNodePath();
}

std::vector<ProgressiveViewStatistics> ProgressiveDrawable::statistics() const
{
    return _views->statistics();
}

void ProgressiveDrawable::accept(osg::PrimitiveFunctor& functor) const
{
    if (_shape) showFaces(*_views->latest(fixedLevel().steps), std::nullopt, functor);
}

void ProgressiveDrawable::accept(osg::PrimitiveIndexFunctor& functor) const
{
    if (_shape) showFaces(*_views->latest(fixedLevel().steps), std::nullopt, functor);
}

osg::BoundingBox ProgressiveDrawable::computeBoundingBox() const
{
    return _shape ? _shape->box() : osg::BoundingBox();
}

void ProgressiveDrawable::resizeGLObjectBuffers(unsigned int contexts)
{
    osg::Drawable::resizeGLObjectBuffers(contexts);
    if (_shape) _shape->resizeGLObjectBuffers(contexts);
}

void ProgressiveDrawable::releaseGLObjects(osg::State* state) const
{
    osg::Drawable::releaseGLObjects(state);
    _views->releaseGLObjects(state);
    if (_shape) _shape->releaseGLObjects(state);
}

} // namespace osgPMObjects
