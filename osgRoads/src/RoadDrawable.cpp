// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <glm/geometric.hpp>

#include <osg/BlendFunc>
#include <osgUtil/CullVisitor>

#include <osgRoads/RoadDrawable>
#include <osgRoads/RoadShader>
#include <osgTraversal/CullFacts>
#include <osgTraversal/DrawOrder>

#include "view/GrainTexture.h"
#include "view/RoadPart.h"
#include "view/RowTexture.h"

namespace osgRoads
{

namespace
{

using namespace osgTraversal;

viewlod::ViewState viewOf(osgUtil::CullVisitor& visitor)
{
    viewlod::ViewState view = detailViewOf(visitor);
    view.pixelsPerTangent /= lodScaleOf(visitor);
    return view;
}

void setState(osg::StateSet& state, const core::RoadMesh& mesh)
{
    std::vector<FloatRow> marks;
    for (const core::MarkRow& row : mesh.marks)
        marks.push_back(std::bit_cast<FloatRow>(row));
    state.setTextureAttributeAndModes(kMarksUnit, makeRowTexture(marks));
    state.setTextureAttributeAndModes(kDecalsUnit, makeRowTexture(mesh.decals));
    state.setTextureAttributeAndModes(kGrainUnit, makeGrainTexture());
    state.addUniform(new osg::Uniform("roadMarks", kMarksUnit));
    state.addUniform(new osg::Uniform("roadGrain", kGrainUnit));
    state.addUniform(new osg::Uniform("roadDecals", kDecalsUnit));
}

osg::ref_ptr<osg::StateSet> binState(int bin)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setRenderBinDetails(bin, "RenderBin");
    return state;
}

osg::ref_ptr<osg::StateSet> fadingState()
{
    osg::ref_ptr<osg::StateSet> state = binState(DrawOrder::kFadingRoads);
    state->setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
    return state;
}

/// Parts the choices: in front those of chunks that are too near to fade anywhere. Returns their number.
std::size_t nearFirst(std::vector<core::ChunkChoice>& choices, const core::RoadMesh& mesh,
                      const viewlod::ViewState& view, const core::RoadViewSettings& settings)
{
    const auto middle = std::stable_partition(
        choices.begin(), choices.end(),
        [&](const core::ChunkChoice& choice)
        {
            const core::RoadChunk& chunk = mesh.chunks[choice.chunk];
            return glm::distance(chunk.centre, view.eyeWorld) + chunk.radius < settings.fadeFromM();
        });
    return static_cast<std::size_t>(middle - choices.begin());
}

} // namespace

RoadDrawable::RoadDrawable() : RoadDrawable(std::make_shared<const core::RoadMesh>()) {}

RoadDrawable::RoadDrawable(std::shared_ptr<const core::RoadMesh> mesh)
    : RoadDrawable(std::make_shared<const core::PagedRoadMesh>(std::move(mesh)))
{
}

RoadDrawable::RoadDrawable(std::shared_ptr<const core::PagedRoadMesh> mesh)
    : _mesh(std::move(mesh)),
      _tree(std::make_shared<const core::ChunkTree>(_mesh->outline())),
      _buffers(std::make_shared<RoadBuffers>(_mesh))
{
    setUseDisplayList(false);
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true);
    setState(*getOrCreateStateSet(), _mesh->outline());
}

RoadDrawable::RoadDrawable(const RoadDrawable& other, const osg::CopyOp& copyOp)
    : osg::Drawable(other, copyOp),
      _mesh(other._mesh),
      _tree(other._tree),
      _buffers(other._buffers),
      _settings(other._settings),
      _groundState(other._groundState)
{
}

RoadDrawable::~RoadDrawable() = default;

foundation::Outcome RoadDrawable::setSettings(const core::RoadViewSettings& settings)
{
    for (const double value :
         {settings.farthestM, settings.liftPx, settings.liftFromM, settings.liftFullM, settings.nearErrorM})
        if (!std::isfinite(value) || value < 0.0)
            return foundation::Error{"RoadDrawable", "a setting is not finite or below 0",
                                     "give lengths in metres, 0 or more"};
    if (!(settings.tolerancePx > 0.0))
        return foundation::Error{"RoadDrawable.tolerancePx", "is not above 0", "give pixels above 0"};
    _settings = settings;
    return foundation::success();
}

void RoadDrawable::accept(osg::NodeVisitor& visitor)
{
    osgUtil::CullVisitor* cullVisitor = visitor.asCullVisitor();
    if (!cullVisitor) return osg::Drawable::accept(visitor);
    if (!visitor.validNodeMask(*this)) return;
    visitor.pushOntoNodePath(this);
    cull(*cullVisitor);
    visitor.popFromNodePath();
}

void RoadDrawable::cull(osgUtil::CullVisitor& visitor)
{
    const osg::BoundingBox& box = getBoundingBox();
    if (!box.valid() || (isCullingActive() && visitor.isCulled(box))) return;
    const viewlod::ViewState view = viewOf(visitor);
    auto choices = core::chooseLevels(_mesh->outline(), *_tree, view, _settings);
    if (choices.empty()) return;
    const std::size_t nearCount = nearFirst(choices, _mesh->outline(), view, _settings);
    const std::vector<core::ChunkChoice> fading(choices.begin() + static_cast<std::ptrdiff_t>(nearCount),
                                                choices.end());
    choices.resize(nearCount);
    osg::RefMatrix& matrix = *visitor.getModelViewMatrix();
    if (seeksNearFar(visitor)) visitor.updateCalculatedNearFar(matrix, box);
    const auto add = [&](const std::vector<core::ChunkChoice>& chosen, RoadStrips strips)
    {
        auto ranges = rangesOf(_mesh->outline(), chosen, strips);
        if (ranges.empty()) return;
        osg::ref_ptr<RoadPart> part =
            new RoadPart(_buffers, std::move(ranges), _settings, view.pixelsPerTangent, box);
        visitor.addDrawableAndDepth(part.get(), &matrix, 0.0F);
    };
    const auto addAll =
        [&](const std::vector<core::ChunkChoice>& chosen, osg::StateSet* paved, osg::StateSet* verges)
    {
        visitor.pushStateSet(paved);
        add(chosen, _groundState ? RoadStrips::paved : RoadStrips::all);
        visitor.popStateSet();
        if (!_groundState) return;
        visitor.pushStateSet(verges);
        visitor.pushStateSet(_groundState.get());
        add(chosen, RoadStrips::ground);
        visitor.popStateSet();
        visitor.popStateSet();
    };
    static const osg::ref_ptr<osg::StateSet> kPaved = binState(DrawOrder::kPavedRoads),
                                             kVerges = binState(DrawOrder::kVerges), kFading = fadingState();
    visitor.pushStateSet(getStateSet());
    addAll(choices, kPaved.get(), kVerges.get());
    addAll(fading, kFading.get(), kFading.get());
    visitor.popStateSet();
}

void RoadDrawable::accept(osg::PrimitiveFunctor& functor) const
{
    std::vector<RoadRange> finest;
    for (const core::RoadChunk& chunk : _mesh->outline().chunks)
        if (!chunk.levels.empty())
            finest.push_back({chunk.levels.front().firstIndex, chunk.levels.front().indexCount});
    showTriangles(*_mesh, finest, functor);
}

osg::BoundingBox RoadDrawable::computeBoundingBox() const
{
    osg::BoundingBox box;
    for (const core::RoadChunk& chunk : _mesh->outline().chunks)
        box.expandBy(osg::BoundingSphere(osg::Vec3(static_cast<float>(chunk.centre.x),
                                                   static_cast<float>(chunk.centre.y),
                                                   static_cast<float>(chunk.centre.z)),
                                         static_cast<float>(chunk.radius) + 1.0F));
    return box;
}

void RoadDrawable::releaseGLObjects(osg::State* state) const
{
    osg::Drawable::releaseGLObjects(state);
    _buffers->releaseGLObjects(state);
}

} // namespace osgRoads
