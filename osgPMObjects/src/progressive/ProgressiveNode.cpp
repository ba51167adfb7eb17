// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <foundation/SettingsCheck.h>

#include <osg/MatrixTransform>
#include <osgUtil/CullVisitor>

#include <osgPMObjects/ProgressiveNode>
#include <osgPMObjects/Serializers>

#include "../settings/ErrorPlace.h"
#include "CullView.h"

namespace osgPMObjects
{

namespace
{

/// Stands here because a linker drops objects of a static library that nobody refers to.
[[maybe_unused]] const bool kAreNodeSerializersRegistered = registerSerializers();

foundation::Outcome checkSelection(const core::SelectionSettings& selection, std::uint32_t levels)
{
    const std::string place = "ProgressiveNode.selection";
    if (selection.method == core::SelectionMethod::budget)
        return foundation::Error{place, "a single object has no budget to share",
                                 "choose another method, or put the objects into a ProgressiveField"};
    return at(place, core::checkSettings(selection, levels));
}

foundation::Outcome checkSwitching(const core::SwitchSettings& switching)
{
    return at("ProgressiveNode.switching", core::checkSettings(switching));
}

foundation::Outcome checkPriority(const core::Priority& priority)
{
    return at("ProgressiveNode.priority", core::checkSettings(priority));
}

std::uint32_t levelsOf(const ProgressiveShape* shape)
{
    return shape ? static_cast<std::uint32_t>(shape->levels().faces.size()) : 1;
}

/// Sets a part of the settings if its check allows.
template<class Part>
foundation::Outcome setIf(const foundation::Outcome& checked, Part& part, const Part& value)
{
    if (checked) part = value;
    return checked;
}

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

foundation::Outcome checkSettings(const ProgressiveNodeSettings& settings, std::uint32_t levels)
{
    foundation::Outcome checked = checkSelection(settings.selection, levels);
    if (checked) checked = checkSwitching(settings.switching);
    if (checked) checked = checkPriority(settings.priority);
    if (!checked) return checked;
    return foundation::SettingsCheck("ProgressiveNode")
        .within("referencePixelsPerTangent", settings.referencePixelsPerTangent, 0.0)
        .outcome();
}

ProgressiveNode::ProgressiveNode(osg::ref_ptr<const ProgressiveShape> shape)
{
    setDrawable(new ProgressiveDrawable(shape));
    addChild(_drawnChild);
}

ProgressiveNode::ProgressiveNode(const ProgressiveNode& other, const osg::CopyOp& copyOp)
    : osg::Group(other, copyOp), _settings(other._settings)
{
    if (!other._drawable) return;
    setDrawable(new ProgressiveDrawable(*other._drawable, copyOp));
    if (const unsigned at = other.getChildIndex(other._drawnChild); at < getNumChildren())
        setChild(at, _drawnChild);
    else
        addChild(_drawnChild);
}

void ProgressiveNode::setDrawable(const osg::ref_ptr<ProgressiveDrawable>& drawable)
{
    _drawable = drawable;
    _drawnChild = drawable;
    const osg::Vec3d origin = shape() ? shape()->origin() : osg::Vec3d();
    if (origin == osg::Vec3d()) return;
    const osg::ref_ptr<osg::MatrixTransform> transform =
        new osg::MatrixTransform(osg::Matrixd::translate(origin));
    transform->addChild(drawable);
    _drawnChild = transform;
}

foundation::Outcome ProgressiveNode::setSettings(const ProgressiveNodeSettings& settings)
{
    return setIf(checkSettings(settings, levelsOf(shape())), _settings, settings);
}

foundation::Outcome ProgressiveNode::setSelection(const core::SelectionSettings& selection)
{
    return setIf(checkSelection(selection, levelsOf(shape())), _settings.selection, selection);
}

foundation::Outcome ProgressiveNode::setSwitching(const core::SwitchSettings& switching)
{
    return setIf(checkSwitching(switching), _settings.switching, switching);
}

foundation::Outcome ProgressiveNode::setPriority(const core::Priority& priority)
{
    return setIf(checkPriority(priority), _settings.priority, priority);
}

bool ProgressiveNode::isShaded() const
{
    return core::takesTime(_settings.switching.method) || std::isfinite(_settings.selection.alpha.goneM);
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
    object.settings = &_settings.selection;
    object.metresPerUnit = view.metresPerUnit;
    object.priority = _settings.priority;
    object.facing = &shape.facing();
    const auto eye =
        core::SelectionView::from(view.view, 1.0 / view.lodScale, _settings.referencePixelsPerTangent);
    return core::LevelSelector(eye).select(object, held);
}

void ProgressiveNode::cull(osgUtil::CullVisitor& visitor)
{
    const osg::Vec3d& origin = _drawable->shape()->origin();
    const bool isMoved = _drawnChild != _drawable;
    if (isMoved)
        visitor.pushModelViewMatrix(
            new osg::RefMatrix(osg::Matrixd::translate(origin) * *visitor.getModelViewMatrix()),
            osg::Transform::RELATIVE_RF);
    _drawable->cull(visitor,
                    [this](const CullView& view, core::HeldLevel& held) { return choose(view, held); },
                    {_settings.switching, _settings.number, isShaded()});
    if (isMoved) visitor.popModelViewMatrix();
}

void ProgressiveNode::traverse(osg::NodeVisitor& visitor)
{
    osgUtil::CullVisitor* const cullVisitor = visitor.asCullVisitor();
    if (!cullVisitor || !shape()) return osg::Group::traverse(visitor);
    for (unsigned i = 0; i < getNumChildren(); ++i)
        if (getChild(i) == _drawnChild)
            cull(*cullVisitor);
        else
            getChild(i)->accept(visitor);
}

} // namespace osgPMObjects
