// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osg/Group>
#include <osg/LightModel>
#include <osgUtil/CullVisitor>

#include <osgTerrainROAM/core/bisection/BisectionFile.h>

#include <osgTerrainROAM/BisectionDrawable>
#include <osgTraversal/AllowedError>
#include <osgTraversal/CullFacts>
#include <osgTraversal/NearFar>

#include "view/BisectionViewTable.h"

namespace osgTerrainROAM
{

namespace
{

using namespace osgTraversal;

/// The box of all vertices of the finest surface and of all TINs; floats round.
osg::BoundingBox boxOf(const core::BisectionModel& model)
{
    osg::BoundingBox box;
    const auto add = [&](const glm::dvec3& p)
    { box.expandBy(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)); };
    model.surface.forEachVertex([&](std::uint32_t vertex) { add(model.surface.point(vertex)); });
    for (const core::BisectionPatch& patch : model.patches)
        for (const core::PatchPoint& p : patch.points)
            add(p.point);
    return box;
}

double distanceTo(const osg::BoundingBox& box, const glm::dvec3& eye)
{
    const glm::dvec3 low(box.xMin(), box.yMin(), box.zMin()), high(box.xMax(), box.yMax(), box.zMax());
    return glm::length(glm::max(glm::max(low - eye, eye - high), glm::dvec3(0.0)));
}

} // namespace

BisectionDrawable::BisectionDrawable() = default;

BisectionDrawable::BisectionDrawable(std::shared_ptr<const core::BisectionModel> model)
    : _model(std::move(model)), _box(boxOf(*_model))
{
    _views = std::make_unique<BisectionViewTable>(*_model, _box.center().length() + _box.radius());
    _nearest = std::max(1e-3, 1e-4 * _box.radius());
}

BisectionDrawable::BisectionDrawable(const BisectionDrawable& other, const osg::CopyOp& copyOp)
    : osgTraversal::CulledDrawable(other, copyOp),
      _model(other._model),
      _box(other._box),
      _tolerancePx(other._tolerancePx),
      _nearest(other._nearest)
{
    if (_model)
        _views = std::make_unique<BisectionViewTable>(*_model, _box.center().length() + _box.radius());
}

BisectionDrawable::~BisectionDrawable() = default;

std::vector<BisectionViewStatistics> BisectionDrawable::statistics() const
{
    return _views ? _views->statistics() : std::vector<BisectionViewStatistics>();
}

osg::ref_ptr<const osg::Geometry> BisectionDrawable::latest() const
{
    return _views ? _views->latest() : nullptr;
}

void BisectionDrawable::cull(osgUtil::CullVisitor& visitor)
{
    const osg::BoundingBox& box = getBoundingBox();
    if (isCullingActive() && visitor.isCulled(box)) return;
    const viewlod::ViewState view = detailViewOf(visitor);
    const osg::ref_ptr<osg::Geometry> geometry =
        _views->answer({visitor.getCurrentCamera(), mainCameraOf(visitor), frameOf(visitor), view.eyeWorld,
                        allowedErrorOf(visitor, view, _tolerancePx, _nearest)});
    const double nearest = std::max(_nearest, distanceTo(box, view.eyeWorld));
    if (seeksNearFar(visitor))
        tellNearFar(visitor, box, view.cornerStretch, nearest * eyePerLocal(*visitor.getModelViewMatrix()));
    if (getStateSet()) visitor.pushStateSet(getStateSet());
    visitor.addDrawableAndDepth(geometry.get(), visitor.getModelViewMatrix(), static_cast<float>(nearest));
    if (getStateSet()) visitor.popStateSet();
}

void BisectionDrawable::accept(osg::PrimitiveFunctor& functor) const
{
    if (!_model) return;
    const osg::ref_ptr<osg::Geometry> drawn = _views->latest();
    if (drawn) return drawn->accept(functor);
    geometryOf(core::BisectionMesh(_model->surface, _model->patches))->accept(functor);
}

void BisectionDrawable::releaseGLObjects(osg::State* state) const
{
    osg::Drawable::releaseGLObjects(state);
    if (_views) _views->releaseGLObjects(state);
}

foundation::Result<osg::ref_ptr<osg::Node>> openBisectionNode(const std::filesystem::path& file)
{
    auto model = core::openBisection(file);
    if (!model) return model.error();
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    group->setName(file.string());
    const osg::ref_ptr<osg::LightModel> bothSides =
        new osg::LightModel; // of cliffs that lean over, and of borders
    bothSides->setTwoSided(true);
    group->getOrCreateStateSet()->setAttributeAndModes(bothSides);
    group->addChild(new BisectionDrawable(std::move(*model)));
    return osg::ref_ptr<osg::Node>(group);
}

} // namespace osgTerrainROAM
