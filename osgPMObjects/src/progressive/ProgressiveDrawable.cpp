// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include <osgUtil/CullVisitor>

#include <osgPMObjects/ProgressiveDrawable>
#include <osgPMObjects/Serializers>

#include "ViewLevelTable.h"

namespace osgPMObjects
{

namespace
{

/// Stands here because a linker drops objects of a static library that nobody refers to.
[[maybe_unused]] const bool kAreDrawableSerializersRegistered = registerSerializers();

bool isScaled(const osg::Matrixd& matrix)
{
    constexpr double kRounding = 1e-6;
    for (int row = 0; row < 3; ++row)
        if (std::abs(osg::Vec3d(matrix(row, 0), matrix(row, 1), matrix(row, 2)).length2() - 1.0) > kRounding)
            return true;
    return false;
}

/// The state above a scaled object: the fixed functions light it with normals of length 1, as the programs of
/// fields do. An unscaled one is drawn without it, as its normals need no rounding.
const osg::StateSet* unitNormals()
{
    static const osg::ref_ptr<osg::StateSet> state = []
    {
        osg::ref_ptr<osg::StateSet> made = new osg::StateSet;
        made->setMode(GL_NORMALIZE, osg::StateAttribute::ON);
        return made;
    }();
    return state;
}

} // namespace

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

void ProgressiveDrawable::setProgressiveShape(osg::ref_ptr<const ProgressiveShape> shape)
{
    _shape = shape;
    _views = std::make_unique<ViewLevelTable>(_shape);
    dirtyBound();
}

foundation::Outcome ProgressiveDrawable::setSteps(std::uint32_t steps)
{
    const std::uint32_t most = _shape ? _shape->progressive().stepCount : 0;
    if (steps > most)
        return foundation::Error{"ProgressiveDrawable.steps",
                                 "the shape has " + std::to_string(most) + " steps, not " +
                                     std::to_string(steps),
                                 "give at most as many as it has"};
    _steps = steps;
    return foundation::success();
}

core::Selection ProgressiveDrawable::fixedLevel() const
{
    return {_steps};
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
    const bool needsUnitNormals = isScaled(*visitor.getModelViewMatrix());
    if (needsUnitNormals) visitor.pushStateSet(unitNormals());
    if (getStateSet()) visitor.pushStateSet(getStateSet());
    cullLevels(visitor, *_shape, _views->find(cullViewOf(visitor), choice, switching), switching.isShaded);
    if (getStateSet()) visitor.popStateSet();
    if (needsUnitNormals) visitor.popStateSet();
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
