// SPDX-License-Identifier: Apache-2.0
#include <osg/MatrixTransform>
#include <osg/Notify>
#include <osgTerrain/Terrain>
#include <osgTerrain/TerrainTile>
#include <osgUtil/CullVisitor>
#include <osgUtil/UpdateVisitor>

#include <osgTerrainROAM/RoamTechnique>
#include <osgTerrainROAM/Serializers>

#include "GroundDrawable.h"
#include "TileGround.h"
#include "TileState.h"

namespace osgTerrainROAM
{

using osgTerrain::TerrainTile;

/// The nodes that one init() has made. Threads: immutable, but for the settings of the drawable.
struct TechniqueBuffer
{
    TileGround ground;
    osg::ref_ptr<RoamDrawable> drawable;
    osg::ref_ptr<osg::MatrixTransform> drawn;       ///< places the drawable
    osg::ref_ptr<osg::MatrixTransform> intersected; ///< places the true ground
};

namespace
{

[[maybe_unused]] const bool kAreTechniqueSerializersRegistered = registerSerializers();

osg::ref_ptr<osg::MatrixTransform> placed(const osg::Matrixd& matrix, osg::Node* child)
{
    osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(matrix);
    transform->addChild(child);
    transform->setThreadSafeRefUnref(true);
    return transform;
}

RoamDrawableSettings withTechniqueSettings(RoamDrawableSettings ofTile, const RoamTechniqueSettings& settings)
{
    ofTile.errorTolerancePx = settings.errorTolerancePx;
    ofTile.maxTriangles = settings.maxTriangles;
    ofTile.morphing = settings.morphing;
    return ofTile;
}

} // namespace

RoamTechnique::RoamTechnique() : _programs(std::make_shared<LayerPrograms>()) {}

RoamTechnique::RoamTechnique(const RoamTechnique& other, const osg::CopyOp& copyOp)
    : osgTerrain::TerrainTechnique(other, copyOp), _programs(other._programs), _settings(other._settings)
{
}

RoamTechnique::~RoamTechnique() = default;

RoamTechnique::BufferPtr RoamTechnique::current() const
{
    const std::lock_guard lock(_bufferMutex);
    return _current;
}

RoamDrawable* RoamTechnique::drawable() const
{
    const BufferPtr buffer = current();
    return buffer ? buffer->drawable.get() : nullptr;
}

foundation::Outcome checkSettings(const RoamTechniqueSettings& settings)
{
    return checkSettings(withTechniqueSettings({}, settings), "RoamTechnique");
}

foundation::Outcome RoamTechnique::setSettings(const RoamTechniqueSettings& settings)
{
    foundation::Outcome checked = checkSettings(settings);
    if (!checked) return checked;
    _settings = settings;
    applySettings();
    return checked;
}

foundation::Outcome RoamTechnique::setErrorTolerancePx(double pixels)
{
    RoamTechniqueSettings settings = _settings;
    settings.errorTolerancePx = pixels;
    return setSettings(settings);
}

foundation::Outcome RoamTechnique::setMaxTriangles(std::uint32_t triangles)
{
    RoamTechniqueSettings settings = _settings;
    settings.maxTriangles = triangles;
    return setSettings(settings);
}

void RoamTechnique::setMorphing(bool on)
{
    _settings.morphing = on;
    applySettings();
}

/// The settings have been checked: the drawable takes them.
void RoamTechnique::applySettings() const
{
    RoamDrawable* const drawn = drawable();
    if (!drawn) return;
    const foundation::Outcome set = drawn->setSettings(withTechniqueSettings(drawn->settings(), _settings));
    if (!set) OSG_WARN << set.error().message() << '\n';
}

RoamTechnique::BufferPtr RoamTechnique::build(int dirtyMask) const
{
    const BufferPtr before = current();
    const bool sameGround =
        before && (dirtyMask & (TerrainTile::ELEVATION_DIRTY | TerrainTile::EDGES_DIRTY)) == 0;
    const auto ground = sameGround ? before->ground : tileGround(*_terrainTile);
    if (!ground)
    {
        OSG_WARN << "osgTerrainROAM: tile '" << _terrainTile->getName()
                 << "' has no locator with an extent, or no height, and is not drawn: give its elevation "
                    "layer both\n";
        return nullptr;
    }
    auto buffer = std::make_shared<TechniqueBuffer>();
    buffer->ground = *ground;
    buffer->drawable = new RoamDrawable(ground->tile);
    // A deep skirt would show through transparent ground.
    const foundation::Outcome set = buffer->drawable->setSkirtM(blends(*_terrainTile) ? 0.0 : ground->skirtM);
    if (!set)
        OSG_WARN << "osgTerrainROAM: tile '" << _terrainTile->getName() << "': " << set.error().message()
                 << '\n';
    buffer->drawable->setStateSet(tileState(*_terrainTile, *ground, *_programs));
    buffer->drawn = placed(ground->modelFromLocal, buffer->drawable);
    buffer->intersected =
        sameGround ? before->intersected : placed(ground->modelFromLocal, new GroundDrawable(*ground));
    return buffer;
}

void RoamTechnique::init(int dirtyMask, bool assumeMultiThreaded)
{
    const std::lock_guard lock(_buildMutex);
    if (!_terrainTile || dirtyMask == TerrainTile::NOT_DIRTY) return;
    BufferPtr made = build(dirtyMask);
    bool isFirst = false;
    {
        const std::lock_guard bufferLock(_bufferMutex);
        isFirst = !_current || !assumeMultiThreaded;
        (isFirst ? _current : _next) = std::move(made);
    }
    if (isFirst)
        applySettings();
    else if (_terrainTile->getTerrain())
        _terrainTile->getTerrain()->updateTerrainTileOnNextFrame(_terrainTile);
    _terrainTile->setDirtyMask(TerrainTile::NOT_DIRTY);
}

void RoamTechnique::update(osgUtil::UpdateVisitor* visitor)
{
    if (_terrainTile) _terrainTile->osg::Group::traverse(*visitor);
    {
        const std::lock_guard lock(_bufferMutex);
        if (!_next) return;
        _current = std::move(_next);
        _next.reset();
    }
    applySettings();
}

void RoamTechnique::cull(osgUtil::CullVisitor* visitor)
{
    if (const BufferPtr buffer = current()) buffer->drawn->accept(*visitor);
}

void RoamTechnique::traverse(osg::NodeVisitor& visitor)
{
    if (!_terrainTile) return;
    osgUtil::CullVisitor* const cullVisitor = visitor.asCullVisitor();
    if (cullVisitor) return cull(cullVisitor);
    if (_terrainTile->getDirty()) _terrainTile->init(_terrainTile->getDirtyMask(), false);
    osgUtil::UpdateVisitor* const updateVisitor = visitor.asUpdateVisitor();
    if (updateVisitor) return update(updateVisitor);
    const BufferPtr buffer = current();
    if (!buffer) return;
    (visitor.asIntersectionVisitor() ? buffer->intersected : buffer->drawn)->accept(visitor);
}

void RoamTechnique::releaseGLObjects(osg::State* state) const
{
    const std::lock_guard lock(_bufferMutex);
    for (const BufferPtr& buffer : {_current, _next})
        if (buffer) buffer->drawn->releaseGLObjects(state);
}

} // namespace osgTerrainROAM
