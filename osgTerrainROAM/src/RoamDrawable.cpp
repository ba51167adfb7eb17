// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <shared_mutex>

#include <osgTerrainROAM/RoamDrawable>
#include <osgTraversal/CullFacts>

#include "view/ClippedTriangles.h"
#include "view/TileBounds.h"
#include "view/ViewGroupTable.h"
#include "view/ViewPart.h"

namespace osgTerrainROAM
{

namespace
{

using namespace osgTraversal;

/// The projection without a far plane, its near plane where we want it.
glm::dmat4 withoutDepth(glm::dmat4 projection, double nearM)
{
    projection[2][2] = isParallel(projection) ? 0.0 : -1.0;
    projection[3][2] = isParallel(projection) ? 0.0 : -2.0 * nearM;
    return projection;
}

viewlod::ViewState viewOf(osgUtil::CullVisitor& visitor, double nearestM)
{
    const osg::Matrixd& eyeFromLocal = *visitor.getModelViewMatrix();
    const double scale = eyePerLocal(eyeFromLocal);
    glm::dmat4 projection = toGlm(*visitor.getProjectionMatrix());
    if (seeksNearFar(visitor)) projection = withoutDepth(projection, nearestM * scale);
    viewlod::ViewState view = viewStateOf(visitor, eyeFromLocal, projection);
    view.nearM /= scale;
    if (isParallel(projection))
    {
        view.cornerStretch = 1.0;
        view.nearM = nearestM;
    }
    view.nearM = std::max(view.nearM, 1e-3);
    view.pixelsPerTangent /= lodScaleOf(visitor);
    return view;
}

/// Tells OSG how near and how far this surface reaches, and lets it have so near a plane. In eye space.
void tellNearFar(osgUtil::CullVisitor& visitor, const osg::BoundingBox& box, const viewlod::ViewState& view,
                 double nearestM)
{
    const osg::Matrixd& eyeFromLocal = *visitor.getModelViewMatrix();
    double farM = 0.0;
    for (unsigned int i = 0; i < 8; ++i)
        farM = std::max(farM, -(osg::Vec3d(box.corner(i)) * eyeFromLocal).z());
    if (farM <= 0.0) return;
    // A point at the picture's corner is farther away than it is deep.
    const double nearM = std::max(0.95 * nearestM / std::sqrt(view.cornerStretch), farM * 1e-6);
    if (nearM < visitor.getCalculatedNearPlane()) visitor.setCalculatedNearPlane(nearM);
    if (farM > visitor.getCalculatedFarPlane()) visitor.setCalculatedFarPlane(farM);
    const double ratio = 0.95 * visitor.getCalculatedNearPlane() / visitor.getCalculatedFarPlane();
    if (ratio < visitor.getNearFarRatio()) visitor.setNearFarRatio(ratio);
}

} // namespace

RoamDrawable::RoamDrawable() : RoamDrawable(nullptr) {}

RoamDrawable::RoamDrawable(std::shared_ptr<const core::RoamTile> tile)
    : _tile(std::move(tile)), _groups(newGroups(0))
{
    setUseDisplayList(false);
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true);
    if (_tile) _box = tileBounds(_tile->tile);
    if (_tile) _defaultErrorM = 0.25 * std::max(_tile->tile.field().spacingEastM, 0.01);
}

RoamDrawable::RoamDrawable(const RoamDrawable& other, const osg::CopyOp& copyOp)
    : osg::Drawable(other, copyOp),
      _tile(other._tile),
      _box(other._box),
      _groups(newGroups(other._patchExponent)),
      _patchExponent(other._patchExponent),
      _errorTolerancePx(other._errorTolerancePx),
      _maxTriangles(other._maxTriangles),
      _maxAdaptTimeUs(other._maxAdaptTimeUs),
      _clock(other._clock),
      _isMorphing(other._isMorphing),
      _skirtM(other._skirtM),
      _nearestM(other._nearestM),
      _defaultErrorM(other._defaultErrorM)
{
}

RoamDrawable::~RoamDrawable() = default;

std::unique_ptr<ViewGroupTable> RoamDrawable::newGroups(int patchExponent) const
{
    std::optional<core::SplitBounds> bounds;
    if (_tile) bounds.emplace(_tile, patchExponent);
    return std::make_unique<ViewGroupTable>(std::move(bounds));
}

void RoamDrawable::setPatchExponent(int exponent)
{
    if (exponent == _patchExponent) return;
    _patchExponent = exponent;
    _groups = newGroups(exponent);
}

void RoamDrawable::followEdits(std::span<const core::GridRect> moved)
{
    const std::shared_lock lock(_tile->mutex());
    const core::PlacedTile& tile = _tile->tile;
    for (const core::GridRect& rect : moved)
        tile.samples().forEachSample(
            rect,
            [&](int column, int row)
            {
                const glm::dvec3 p = tile.position(column, row);
                for (const double slackM : {-0.01, 0.01}) // floats round
                    _box.expandBy(osg::Vec3f(osg::Vec3d(p.x + slackM, p.y + slackM, p.z + slackM)));
            });
    dirtyBound();
}

std::vector<ViewGroupStatistics> RoamDrawable::statistics() const
{
    return _groups->statistics();
}

void RoamDrawable::accept(osg::NodeVisitor& visitor)
{
    osgUtil::CullVisitor* cullVisitor = visitor.asCullVisitor();
    if (!cullVisitor) return osg::Drawable::accept(visitor);
    if (!_tile || !visitor.validNodeMask(*this)) return;
    visitor.pushOntoNodePath(this);
    cull(*cullVisitor);
    visitor.popFromNodePath();
}

void RoamDrawable::cull(osgUtil::CullVisitor& visitor)
{
    const osg::BoundingBox& box = getBoundingBox();
    if (isCullingActive() && visitor.isCulled(box)) return;

    ViewRequest request;
    request.camera = visitor.getCurrentCamera();
    request.mainCamera = mainCameraOf(visitor);
    request.frame = frameOf(visitor);
    request.target.view = viewOf(visitor, _nearestM);
    request.target.budget.errorTolerancePx = _errorTolerancePx;
    request.target.budget.maxTriangles = _maxTriangles;
    request.target.budget.maxTimeUs = _maxAdaptTimeUs;
    request.target.budget.clock = _clock;
    request.target.isMorphing = _isMorphing;
    request.target.skirtM = _skirtM;
    const viewlod::ViewState view = request.target.view;
    if (isParallel(toGlm(*visitor.getProjectionMatrix())))
        request.target.errorM = _errorTolerancePx / view.pixelsPerTangent;

    const std::optional<unsigned int> contextId = contextIdOf(visitor);
    const ViewGroupTable::Match match = _groups->find(request);
    ViewAnswer answer = match.borrowed
                            ? match.group->answerAsIs(view.frustum, view.eyeWorld, contextId)
                            : match.group->answer(request.frame, match.target, view.frustum, contextId);
    if (answer.ranges.empty()) return;
    if (seeksNearFar(visitor))
        tellNearFar(visitor, box, view, answer.nearestM * eyePerLocal(*visitor.getModelViewMatrix()));

    if (getStateSet()) visitor.pushStateSet(getStateSet());
    const auto depth = static_cast<float>(answer.nearestM);
    osg::ref_ptr<ViewPart> part = new ViewPart(match.group, std::move(answer), view.frustum, box);
    visitor.addDrawableAndDepth(part.get(), visitor.getModelViewMatrix(), depth);
    if (getStateSet()) visitor.popStateSet();
}

void RoamDrawable::accept(osg::PrimitiveFunctor& functor) const
{
    if (!_tile) return;
    ClippedTriangles triangles;
    _groups->latest(_defaultErrorM)
        ->visitMesh([&](const core::RoamMesh& mesh)
                    { triangles = clippedTriangles(mesh.tile().tile, mesh.drawn()); });
    triangles.accept(functor);
}

osg::BoundingBox RoamDrawable::computeBoundingBox() const
{
    return _box;
}

void RoamDrawable::releaseGLObjects(osg::State* state) const
{
    osg::Drawable::releaseGLObjects(state);
    _groups->releaseGLObjects(state);
}

} // namespace osgTerrainROAM
