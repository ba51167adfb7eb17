// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <osg/MatrixTransform>
#include <osgUtil/CullVisitor>

#include <osgPMObjects/ProgressiveNode>
#include <osgPMObjects/Serializers>

#include "CullView.h"

namespace osgPMObjects
{

namespace
{

/// Here, for a linker leaves out of a static library what nobody asks for: who has nodes can write them.
[[maybe_unused]] const bool kAreSerializersRegistered = registerSerializers();

core::BoundingSphere inMetres(const core::BoundingSphere& sphere, double metresPerUnit)
{
    return {sphere.centre * metresPerUnit, sphere.radius * metresPerUnit};
}

core::OrientedBox inMetres(const osg::BoundingBox& box, double metresPerUnit)
{
    const osg::Vec3d centre = osg::Vec3d(box.center()) * metresPerUnit;
    const osg::Vec3d half = (osg::Vec3d(box._max) - osg::Vec3d(box._min)) * (0.5 * metresPerUnit);
    return {{centre.x(), centre.y(), centre.z()}, glm::dmat3(1.0), {half.x(), half.y(), half.z()}};
}

} // namespace

ProgressiveNode::ProgressiveNode(osg::ref_ptr<const ProgressiveShape> shape)
{
    place(new ProgressiveDrawable(shape));
    addChild(_place);
}

ProgressiveNode::ProgressiveNode(const ProgressiveNode& other, const osg::CopyOp& copyOp)
    : osg::Group(other, copyOp),
      _settings(other._settings),
      _switching(other._switching),
      _number(other._number),
      _priority(other._priority),
      _referencePixelsPerTangent(other._referencePixelsPerTangent)
{
    if (!other._drawable) return;
    place(new ProgressiveDrawable(*other._drawable, copyOp));
    if (const unsigned at = other.getChildIndex(other._place); at < getNumChildren())
        setChild(at, _place);
    else
        addChild(_place);
}

void ProgressiveNode::place(const osg::ref_ptr<ProgressiveDrawable>& drawable)
{
    _drawable = drawable;
    _place = drawable;
    const osg::Vec3d origin = shape() ? shape()->origin() : osg::Vec3d();
    if (origin == osg::Vec3d()) return;
    const osg::ref_ptr<osg::MatrixTransform> transform =
        new osg::MatrixTransform(osg::Matrixd::translate(origin));
    transform->addChild(drawable);
    _place = transform;
}

foundation::Outcome ProgressiveNode::setSelection(const core::SelectionSettings& settings)
{
    if (settings.method == core::SelectionMethod::budget)
        return foundation::Error{getName(), "a single object has no budget to share",
                                 "choose another method, or put the objects into one scene selector"};
    const std::uint32_t levels = shape() ? static_cast<std::uint32_t>(shape()->levels().faces.size()) : 1;
    const foundation::Outcome outcome = core::checkSettings(settings, levels);
    if (outcome) _settings = settings;
    return outcome;
}

foundation::Outcome ProgressiveNode::setSwitching(const core::SwitchSettings& settings)
{
    const foundation::Outcome outcome = core::checkSettings(settings);
    if (outcome) _switching = settings;
    return outcome;
}

bool ProgressiveNode::isShaded() const
{
    return core::takesTime(_switching.method) || std::isfinite(_settings.alpha.goneM);
}

std::vector<ProgressiveViewStatistics> ProgressiveNode::statistics() const
{
    return _drawable ? _drawable->statistics() : std::vector<ProgressiveViewStatistics>();
}

core::Selection ProgressiveNode::choose(const CullView& view, core::HeldLevel& held) const
{
    const ProgressiveShape& shape = *_drawable->shape();
    core::SelectableObject object;
    object.sphere = inMetres(shape.sphere(), view.metresPerUnit);
    object.box = inMetres(shape.box(), view.metresPerUnit);
    object.table = &shape.levels();
    object.settings = &_settings;
    object.metresPerUnit = view.metresPerUnit;
    object.priority = _priority;
    object.facing = &shape.facing();
    const auto eye = core::SelectionView::from(view.view, 1.0 / view.lodScale, _referencePixelsPerTangent);
    return core::LevelSelector(eye).select(object, held);
}

void ProgressiveNode::cull(osgUtil::CullVisitor& visitor)
{
    const osg::Vec3d& origin = _drawable->shape()->origin();
    const bool isMoved = _place != _drawable;
    if (isMoved)
        visitor.pushModelViewMatrix(
            new osg::RefMatrix(osg::Matrixd::translate(origin) * *visitor.getModelViewMatrix()),
            osg::Transform::RELATIVE_RF);
    _drawable->cull(visitor,
                    [this](const CullView& view, core::HeldLevel& held) { return choose(view, held); },
                    {_switching, _number, isShaded()});
    if (isMoved) visitor.popModelViewMatrix();
}

void ProgressiveNode::traverse(osg::NodeVisitor& visitor)
{
    osgUtil::CullVisitor* const cullVisitor = visitor.asCullVisitor();
    if (!cullVisitor || !shape()) return osg::Group::traverse(visitor);
    for (unsigned i = 0; i < getNumChildren(); ++i)
        if (getChild(i) == _place)
            cull(*cullVisitor);
        else
            getChild(i)->accept(visitor);
}

} // namespace osgPMObjects
