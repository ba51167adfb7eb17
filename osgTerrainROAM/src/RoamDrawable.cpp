// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <shared_mutex>

#include <osgTerrainROAM/core/method/PrepareTerrain.h>

#include <osgTerrainROAM/RoamDrawable>
#include <osgTerrainROAM/Serializers>
#include <osgTraversal/CullFacts>
#include <osgTraversal/NearFar>

#include "view/ClippedTriangles.h"
#include "view/TileBounds.h"
#include "view/ViewGroupTable.h"
#include "view/ViewPart.h"

namespace osgTerrainROAM
{

namespace
{

using namespace osgTraversal;

[[maybe_unused]] const bool kAreDrawableSerializersRegistered = registerSerializers();

/// Returns the projection without a far plane, and with its near plane at `nearM`.
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

} // namespace

RoamDrawable::RoamDrawable() : RoamDrawable(std::shared_ptr<const core::RoamTile>()) {}

RoamDrawable::RoamDrawable(std::shared_ptr<const core::RoamTile> tile)
    : RoamDrawable(std::move(tile), core::Method::roam, nullptr)
{
}

RoamDrawable::RoamDrawable(std::shared_ptr<const core::RoamTile> tile, core::Method method,
                           core::PreparedPtr terrain)
    : _tile(std::move(tile)), _prepared(std::move(terrain))
{
    _settings.method = method;
    if (_tile)
    {
        if (!_prepared) _prepared = *prepared(_settings); // ROAM takes every tile
        _box = tileBounds(_tile->tile);
    }
    _groups = std::make_unique<ViewGroupTable>(_prepared);
}

RoamDrawable::RoamDrawable(const RoamDrawable& other, const osg::CopyOp& copyOp)
    : osgTraversal::CulledDrawable(other, copyOp),
      _tile(other._tile),
      _box(other._box),
      _prepared(other._prepared),
      _groups(std::make_unique<ViewGroupTable>(_prepared)),
      _settings(other._settings),
      _closesEdge(other._closesEdge)
{
}

RoamDrawable::~RoamDrawable() = default;

/// What the settings' method has prepared: what there is already, if it serves.
foundation::Result<core::PreparedPtr> RoamDrawable::prepared(const RoamDrawableSettings& settings) const
{
    const bool isSame =
        settings.method == _settings.method && settings.patchExponent == _settings.patchExponent;
    if (!_tile || (_prepared && isSame)) return _prepared;
    const std::shared_lock lock(_tile->mutex());
    return core::prepareTerrain(_tile, methodRequest(settings));
}

foundation::Outcome RoamDrawable::setSettings(const RoamDrawableSettings& settings)
{
    foundation::Outcome checked = checkSettings(settings);
    if (!checked) return checked;
    const auto terrain = prepared(settings);
    if (!terrain) return terrain.error();
    const std::uint32_t fewest = *terrain ? (*terrain)->fewestTriangles() : 2;
    if (settings.maxTriangles < fewest)
        return foundation::Error{"RoamDrawable.maxTriangles",
                                 std::to_string(settings.maxTriangles) +
                                     " are too few: " + std::string(core::methodName(settings.method)) +
                                     " draws " + std::to_string(fewest) + " or more over this tile",
                                 "give at least these"};
    _settings = settings;
    if (*terrain != _prepared) _groups = std::make_unique<ViewGroupTable>(_prepared = *terrain);
    return checked;
}

template<class Value>
foundation::Outcome RoamDrawable::set(Value RoamDrawableSettings::*setting, Value value)
{
    RoamDrawableSettings settings = _settings;
    settings.*setting = value;
    return setSettings(settings);
}

foundation::Outcome RoamDrawable::setErrorTolerancePx(double pixels)
{
    return set(&RoamDrawableSettings::errorTolerancePx, pixels);
}

foundation::Outcome RoamDrawable::setMaxTriangles(std::uint32_t triangles)
{
    return set(&RoamDrawableSettings::maxTriangles, triangles);
}

foundation::Outcome RoamDrawable::setMaxAdaptTimeUs(double us)
{
    return set(&RoamDrawableSettings::maxAdaptTimeUs, us);
}

foundation::Outcome RoamDrawable::setSkirtM(std::optional<double> leastM)
{
    return set(&RoamDrawableSettings::skirtM, leastM);
}

foundation::Outcome RoamDrawable::setPatchExponent(int exponent)
{
    return set(&RoamDrawableSettings::patchExponent, exponent);
}

foundation::Outcome RoamDrawable::setMorphing(bool on)
{
    return set(&RoamDrawableSettings::morphing, on);
}

foundation::Outcome RoamDrawable::setMethod(core::Method method)
{
    return set(&RoamDrawableSettings::method, method);
}

foundation::Outcome RoamDrawable::setNearestM(double metres)
{
    return set(&RoamDrawableSettings::nearestM, metres);
}

foundation::Outcome RoamDrawable::setDefaultErrorM(std::optional<double> metres)
{
    return set(&RoamDrawableSettings::defaultErrorM, metres);
}

/// The setting, or what it is by default for this tile.
double RoamDrawable::defaultErrorM() const
{
    return _settings.defaultErrorM.value_or(0.25 * std::max(_tile->tile.field().spacingEastM, 0.01));
}

foundation::Outcome RoamDrawable::setViewMarginDeg(std::optional<double> degrees)
{
    return set(&RoamDrawableSettings::viewMarginDeg, degrees);
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

void RoamDrawable::cull(osgUtil::CullVisitor& visitor)
{
    const osg::BoundingBox& box = getBoundingBox();
    if (isCullingActive() && visitor.isCulled(box)) return;

    ViewRequest request;
    request.camera = visitor.getCurrentCamera();
    request.mainCamera = mainCameraOf(visitor);
    request.frame = frameOf(visitor);
    request.target.view = viewOf(visitor, _settings.nearestM);
    request.target.budget.errorTolerancePx = _settings.errorTolerancePx;
    request.target.budget.maxTriangles = _settings.maxTriangles;
    request.target.budget.maxTimeUs = _settings.maxAdaptTimeUs;
    request.target.budget.clock = _settings.adaptClock;
    request.target.isMorphing = _settings.morphing;
    request.target.skirtM = _settings.skirtM;
    if (_closesEdge && !_settings.skirtM) request.target.skirtM = 0.0;
    const viewlod::ViewState view = request.target.view;
    if (isParallel(toGlm(*visitor.getProjectionMatrix())))
        request.target.errorM = _settings.errorTolerancePx / view.pixelsPerTangent;
    else if (_settings.viewMarginDeg)
        request.target.sight.add(view, glm::radians(*_settings.viewMarginDeg));

    const std::optional<unsigned int> contextId = contextIdOf(visitor);
    const ViewGroupTable::Match match = _groups->find(request);
    ViewAnswer answer = match.borrowed
                            ? match.group->answerAsIs(view.frustum, view.eyeWorld, contextId)
                            : match.group->answer(request.frame, match.target, view.frustum, contextId);
    if (answer.ranges.empty()) return;
    if (seeksNearFar(visitor))
        tellNearFar(visitor, box, view.cornerStretch,
                    answer.nearestM * eyePerLocal(*visitor.getModelViewMatrix()));

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
    _groups->latest(defaultErrorM())
        ->visitMesh([&](const core::TerrainMesh& mesh)
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
