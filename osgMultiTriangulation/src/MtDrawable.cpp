// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include <osgUtil/CullVisitor>

#include <osgMultiTriangulation/MtDrawable>
#include <osgTraversal/AllowedError>
#include <osgTraversal/CullFacts>
#include <osgTraversal/NearFar>
#include <shaders/osgMultiTriangulation.h>

#include "view/MtPart.h"

namespace osgMultiTriangulation
{

namespace
{

using namespace osgTraversal;

osg::BoundingBox boxOf(const core::DrawnSurface::Cell& cell)
{
    return {static_cast<float>(cell.low.x),  static_cast<float>(cell.low.y),
            static_cast<float>(cell.low.z),  static_cast<float>(cell.high.x),
            static_cast<float>(cell.high.y), static_cast<float>(cell.high.z)};
}

double distanceTo(const core::DrawnSurface::Cell& cell, const glm::dvec3& eye)
{
    return glm::length(glm::max(glm::max(cell.low - eye, eye - cell.high), glm::dvec3(0.0)));
}

} // namespace

MtDrawable::MtDrawable() = default;

MtDrawable::MtDrawable(std::unique_ptr<core::SurfaceFollower> follower,
                       const osgTerrainROAM::RoamTerrain& terrain, const osg::BoundingBox& box, bool waits)
    : _follower(std::move(follower)),
      _tile(terrain.tile()),
      _ground(terrain.drawable()),
      _views(std::make_unique<MtViewTable>(_follower, box.radius())),
      _box(box),
      _waits(waits)
{
}

MtDrawable::MtDrawable(const MtDrawable& other, const osg::CopyOp& copyOp)
    : osgTraversal::CulledDrawable(other, copyOp),
      _follower(other._follower),
      _tile(other._tile),
      _ground(other._ground),
      _views(other._follower ? std::make_unique<MtViewTable>(other._follower, other._box.radius()) : nullptr),
      _box(other._box),
      _waits(other._waits)
{
}

MtDrawable::~MtDrawable() = default;

void MtDrawable::takeLook(osgTerrainROAM::TerrainMaterial& material)
{
    material.lendLook(getOrCreateStateSet(), {shaders::kTriangulationVertexMain, "", nullptr, ""});
}

std::vector<MtViewStatistics> MtDrawable::statistics() const
{
    return _views ? _views->statistics() : std::vector<MtViewStatistics>();
}

void MtDrawable::cull(osgUtil::CullVisitor& visitor)
{
    const osg::BoundingBox& box = getBoundingBox();
    if (isCullingActive() && visitor.isCulled(box)) return;
    const viewlod::ViewState view = detailViewOf(visitor);
    const osgTerrainROAM::RoamDrawableSettings& settings = _ground->settings();
    MtAnswer answer =
        _views->answer({visitor.getCurrentCamera(), mainCameraOf(visitor), frameOf(visitor), view.eyeWorld,
                        allowedErrorOf(visitor, view, settings.errorTolerancePx, settings.nearestM)},
                       _waits);
    std::vector<std::uint32_t> cells;
    double nearestM = kEverywhere;
    for (std::uint32_t c = 0; c < answer.surface->cells.size(); ++c)
    {
        const core::DrawnSurface::Cell& cell = answer.surface->cells[c];
        if (visitor.isCulled(boxOf(cell))) continue;
        cells.push_back(c);
        nearestM = std::min(nearestM, distanceTo(cell, view.eyeWorld));
    }
    if (cells.empty()) return;
    nearestM = std::max(nearestM, settings.nearestM);
    if (seeksNearFar(visitor))
        tellNearFar(visitor, box, view.cornerStretch, nearestM * eyePerLocal(*visitor.getModelViewMatrix()));
    if (getStateSet()) visitor.pushStateSet(getStateSet());
    const osg::ref_ptr<MtPart> part =
        new MtPart(std::move(answer), std::move(cells), _follower->frame().vertexStep, _tile, box);
    visitor.addDrawableAndDepth(part.get(), visitor.getModelViewMatrix(), static_cast<float>(nearestM));
    if (getStateSet()) visitor.popStateSet();
}

void MtDrawable::accept(osg::PrimitiveFunctor& functor) const
{
    if (!_follower) return;
    auto surface = _views->latest();
    if (!surface) surface = _follower->coarsest();
    std::vector<std::uint32_t> cells(surface->cells.size());
    std::iota(cells.begin(), cells.end(), 0u);
    showCells(*surface, cells, _follower->frame().vertexStep, functor);
}

void MtDrawable::releaseGLObjects(osg::State* state) const
{
    osg::Drawable::releaseGLObjects(state);
    if (_views) _views->releaseGLObjects(state);
}

} // namespace osgMultiTriangulation
