// SPDX-License-Identifier: Apache-2.0
#include <foundation/SettingsCheck.h>

#include <osgUtil/CullVisitor>

#include <osgPMObjects/ObjectShader>
#include <osgPMObjects/ProgressiveField>
#include <osgPMObjects/Serializers>

#include "../settings/ErrorPlace.h"
#include "FieldContents.h"
#include "FieldSolid.h"
#include "FieldStates.h"
#include "FieldViews.h"

namespace osgPMObjects
{

namespace
{

/// Stands here because a linker drops objects of a static library that nobody refers to.
[[maybe_unused]] const bool kAreFieldSerializersRegistered = registerSerializers();

foundation::Outcome checkBudget(const core::SceneBudgetSettings& budget)
{
    return at("ProgressiveField.budget", core::checkSettings(budget));
}

foundation::Outcome checkAttention(const core::AttentionRule& attention)
{
    return at("ProgressiveField.attention", core::checkSettings(attention));
}

/// The states of a batch, one for each pass over its instances.
std::vector<osg::StateSet*> statesOf(const core::FieldBatch& batch, const FieldKind& kind)
{
    const FieldStates& states = FieldStates::shared();
    switch (batch.pass)
    {
    case core::FieldPass::settled:
        return {states.settled.get()};
    case core::FieldPass::switching:
        return {(kind.switching.method == core::SwitchMethod::geomorph ? states.morphing : states.screenDoor)
                    .get()};
    case core::FieldPass::blended:
        break;
    }
    return {states.blendedDepth.get(), states.blendedColour.get()};
}

void addParts(osgUtil::CullVisitor& visitor, const std::shared_ptr<const CulledField>& culled,
              const core::FieldBatch& batch, const osg::ref_ptr<const FieldMesh>& mesh)
{
    const auto groups = mesh->shape().groups();
    for (std::uint32_t group = 0; group < groups.size(); ++group)
    {
        const osg::StateSet* const state = groups[group].state;
        const osg::ref_ptr<FieldPart> part = new FieldPart(culled, batch, mesh, group);
        const bool hasLeaves = mesh->hasLeaves(group);
        if (hasLeaves) visitor.pushStateSet(FieldStates::shared().leaves);
        if (state) visitor.pushStateSet(state);
        visitor.apply(*part);
        if (state) visitor.popStateSet();
        if (hasLeaves) visitor.popStateSet();
    }
}

std::unique_ptr<FieldSolid> solidOf(const std::shared_ptr<FieldViews>& views,
                                    const std::vector<osg::ref_ptr<FieldMesh>>& meshes)
{
    if (!views) return nullptr;
    return std::make_unique<FieldSolid>(
        FieldSolid::Source{std::shared_ptr<const core::Field>(views, &views->field()), meshes});
}

} // namespace

foundation::Outcome checkSettings(const ProgressiveFieldSettings& settings)
{
    foundation::Outcome checked = checkBudget(settings.budget);
    if (checked) checked = checkAttention(settings.attention);
    if (!checked) return checked;
    return foundation::SettingsCheck("ProgressiveField")
        .within("referencePixelsPerTangent", settings.referencePixelsPerTangent, 0.0)
        .outcome();
}

ProgressiveField::ProgressiveField()
{
    addObjectShading(*getOrCreateStateSet());
}

ProgressiveField::ProgressiveField(const ProgressiveField& other, const osg::CopyOp& copyOp)
    : osg::Node(other, copyOp),
      _kinds(other._kinds),
      _meshes(other._meshes),
      _views(other._views ? std::make_shared<FieldViews>(other._views->field()) : nullptr),
      _solid(solidOf(_views, _meshes)),
      _settings(other._settings)
{
}

ProgressiveField::~ProgressiveField() = default;

foundation::Outcome ProgressiveField::setContents(std::vector<FieldKind> kinds,
                                                  std::vector<FieldInstance> instances)
{
    if (foundation::Outcome checked = checkContents(kinds, instances); !checked) return checked;
    std::vector<osg::ref_ptr<FieldMesh>> meshes = meshesOf(kinds, _meshes);
    std::vector<core::FieldObject> objects = objectsOf(instances);
    instances = {}; // its memory serves the field
    _views = std::make_shared<FieldViews>(core::Field(modelsOf(kinds, meshes), std::move(objects)));
    _kinds = std::move(kinds);
    _meshes = std::move(meshes);
    _solid = solidOf(_views, _meshes);
    dirtyBound();
    return foundation::success();
}

foundation::Outcome ProgressiveField::setSettings(const ProgressiveFieldSettings& settings)
{
    const foundation::Outcome checked = checkSettings(settings);
    if (checked) _settings = settings;
    return checked;
}

foundation::Outcome ProgressiveField::setBudget(const core::SceneBudgetSettings& budget)
{
    const foundation::Outcome checked = checkBudget(budget);
    if (checked) _settings.budget = budget;
    return checked;
}

foundation::Outcome ProgressiveField::setAttention(const core::AttentionRule& attention)
{
    const foundation::Outcome checked = checkAttention(attention);
    if (checked) _settings.attention = attention;
    return checked;
}

std::vector<FieldInstance> ProgressiveField::instances() const
{
    return _views ? instancesOf(_views->field()) : std::vector<FieldInstance>();
}

std::size_t ProgressiveField::instanceCount() const
{
    return _views ? _views->field().objects().size() : 0;
}

std::vector<FieldViewStatistics> ProgressiveField::statistics() const
{
    return _views ? _views->statistics() : std::vector<FieldViewStatistics>();
}

std::optional<std::uint32_t> ProgressiveField::instanceOf(const osg::NodePath& path)
{
    return FieldSolid::instanceOf(path);
}

void ProgressiveField::traverse(osg::NodeVisitor& visitor)
{
    osgUtil::CullVisitor* const cullVisitor = visitor.asCullVisitor();
    if (_solid && visitor.asIntersectionVisitor()) return _solid->accept(visitor);
    if (!cullVisitor || !_views) return osg::Node::traverse(visitor);
    const auto culled = _views->look(cullViewOf(*cullVisitor), _settings);
    for (const core::FieldBatch& batch : culled->drawList.batches)
        for (osg::StateSet* const state : statesOf(batch, _kinds[batch.model]))
        {
            cullVisitor->pushStateSet(state);
            addParts(*cullVisitor, culled, batch, _meshes[batch.model]);
            cullVisitor->popStateSet();
        }
}

osg::BoundingSphere ProgressiveField::computeBound() const
{
    return _views ? _views->bound() : osg::BoundingSphere();
}

void ProgressiveField::resizeGLObjectBuffers(unsigned int contexts)
{
    osg::Node::resizeGLObjectBuffers(contexts);
    for (const auto& mesh : _meshes)
        mesh->resizeGLObjectBuffers(contexts);
}

void ProgressiveField::releaseGLObjects(osg::State* state) const
{
    osg::Node::releaseGLObjects(state);
    if (_views) _views->releaseGLObjects(state);
    for (const auto& mesh : _meshes)
        mesh->releaseGLObjects(state);
}

} // namespace osgPMObjects
