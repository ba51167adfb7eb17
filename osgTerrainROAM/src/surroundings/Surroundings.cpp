// SPDX-License-Identifier: Apache-2.0
#include "Surroundings.h"

#include <algorithm>
#include <array>

#include <osg/Texture2D>
#include <osg/Uniform>
#include <osgUtil/CullVisitor>

#include <osgTerrainROAM/TileUniforms>
#include <osgTraversal/CullFacts>
#include <osgTraversal/DrawOrder>
#include <osgTraversal/NearFar>

#include "../material/ImageBytes.h"
#include "../material/MapTexture.h"
#include "../material/TerrainShader.h"
#include "OuterMaps.h"

namespace osgTerrainROAM
{

namespace
{

constexpr double kReachM = 300000.0; ///< the horizon from 7000 m
/// How much higher the surroundings are drawn per metre of distance, about the error of the tile: no gap
/// opens behind its edge where the tile is drawn above its true height.
constexpr float kLift = 0.0005f;

/// The image of one of the material's maps.
const osg::Image& mapOf(const TerrainMaterial& material, TerrainMaterial::Unit unit)
{
    const osg::StateAttribute* const attribute =
        material.stateSet()->getTextureAttribute(unit, osg::StateAttribute::TEXTURE);
    return *static_cast<const osg::Texture*>(attribute)->getImage(0);
}

osg::Vec2f pairOf(double x, double y)
{
    return {static_cast<float>(x), static_cast<float>(y)};
}

osg::ref_ptr<osg::StateSet> programState(bool season)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setAttributeAndModes(terrainProgram({.season = season, .surroundings = true}));
    return state;
}

/// The visible blocks of the mesh, in the render graph of one cull traversal.
class SurroundingsPart : public osg::Drawable
{
public:
    SurroundingsPart(std::shared_ptr<const core::RoamTile> tile, std::shared_ptr<OuterBuffers> buffers,
                     std::vector<core::IndexRange> ranges, const osg::BoundingBox& box)
        : _tile(std::move(tile)), _buffers(std::move(buffers)), _ranges(std::move(ranges)), _box(box)
    {
        setUseDisplayList(false);
        setSupportsDisplayList(false);
        setUseVertexBufferObjects(true);
        setUseVertexArrayObject(false);
        setDataVariance(osg::Object::STATIC);
    }

    void drawImplementation(osg::RenderInfo& renderInfo) const override
    {
        setTileUniforms(*renderInfo.getState(), _tile->tile.frame(), OuterMesh::kStepM);
        _buffers->draw(*renderInfo.getState(), _ranges);
    }
    osg::BoundingBox computeBoundingBox() const override { return _box; }

private:
    std::shared_ptr<const core::RoamTile> _tile;
    std::shared_ptr<OuterBuffers> _buffers;
    std::vector<core::IndexRange> _ranges;
    osg::BoundingBox _box;
};

double distanceTo(const osg::BoundingBox& box, const osg::Vec3d& eye)
{
    osg::Vec3d away;
    for (int i = 0; i < 3; ++i)
        away[i] = std::max({box._min[i] - eye[i], eye[i] - box._max[i], 0.0});
    return away.length();
}

} // namespace

void OuterBuffers::draw(osg::State& state, const std::vector<core::IndexRange>& ranges)
{
    GpuMesh* copy = nullptr;
    {
        const std::lock_guard lock(_mutex);
        auto& slot = _copies[state.getContextID()];
        if (!slot) slot = std::make_unique<GpuMesh>(state.getContextID());
        copy = slot.get();
    }
    copy->upload(state, _mesh.packet);
    copy->draw(state, ranges);
}

void OuterBuffers::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    for (auto& [contextId, copy] : _copies)
        if (!state || state->getContextID() == contextId) copy->release();
}

Surroundings::Surroundings(std::shared_ptr<const core::RoamTile> tile, TerrainMaterial* material)
    : _tile(std::move(tile)),
      _material(material),
      _maps(new osg::StateSet),
      _plainProgram(programState(false)),
      _seasonProgram(programState(true))
{
    setUseDisplayList(false);
    setSupportsDisplayList(false);
    setCullingActive(false);
    const OuterGround ground(_tile->tile, mapOf(*material, TerrainMaterial::land), kReachM);
    _buffers = std::make_shared<OuterBuffers>(outerMesh(ground, ground.columns(), ground.rows()));
    addMaps(ground, ground.columns(), ground.rows());
}

void Surroundings::addMaps(const OuterGround& ground, const OuterAxis& columns, const OuterAxis& rows)
{
    // The tile may have been edited since the material was made.
    const foundation::KeptFrom kept = _tile->mark() ? _material->kept() : foundation::KeptFrom();
    const auto maps = keptImages<2>(kept, "outer", core::markOfClimate(_material->climate()),
                                    [&]
                                    {
                                        const OuterMaps made =
                                            outerMaps(ground, columns, rows, _material->climate());
                                        return std::array{made.normals, made.land};
                                    });
    const auto add = [&](TerrainMaterial::Unit unit, const char* name, osg::Image* image)
    {
        _maps->setTextureAttributeAndModes(unit, mapTexture(image, osg::Texture::CLAMP_TO_EDGE));
        _maps->addUniform(new osg::Uniform(name, static_cast<int>(unit)));
    };
    add(TerrainMaterial::outerNormals, "outerNormals", maps[0].get());
    add(TerrainMaterial::outerLand, "outerLand", maps[1].get());
    _maps->addUniform(new osg::Uniform("outerInside", pairOf(1.0 / columns.inside(), 1.0 / rows.inside())));
    _maps->addUniform(new osg::Uniform("outerCurve", pairOf(columns.curve(), rows.curve())));
    _maps->addUniform(new osg::Uniform("outerFirst", static_cast<float>(OuterAxis::kOutside + 0.5)));
    _maps->addUniform(new osg::Uniform("outerTexels", static_cast<float>(OuterAxis::kTexels)));
    _maps->addUniform(new osg::Uniform("terrainLift", kLift));
    _maps->addUniform(new osg::Uniform("outerLast", pairOf(ground.last().x, ground.last().y)));
    // Drawn after the tile: what hills of the data hide is not shaded.
    _maps->setRenderBinDetails(osgTraversal::DrawOrder::kSurroundings, "RenderBin");
    // Nothing is clipped at the last sample of the data.
    _maps->addUniform(new osg::Uniform("terrainLastSample", pairOf(1e9, 1e9)));
}

void Surroundings::accept(osg::NodeVisitor& visitor)
{
    osgUtil::CullVisitor* const cullVisitor = visitor.asCullVisitor();
    if (!cullVisitor) return osg::Drawable::accept(visitor);
    if (!visitor.validNodeMask(*this)) return;
    visitor.pushOntoNodePath(this);
    cull(*cullVisitor);
    visitor.popFromNodePath();
}

void Surroundings::cull(osgUtil::CullVisitor& visitor)
{
    osg::Matrixd localFromEye;
    localFromEye.invert(*visitor.getModelViewMatrix());
    const osg::Vec3d eye = localFromEye.getTrans();
    std::vector<core::IndexRange> ranges;
    osg::BoundingBox box;
    double nearestM = 1e30;
    for (const OuterMesh::Block& block : _buffers->mesh().blocks)
    {
        if (visitor.isCulled(block.box)) continue;
        box.expandBy(block.box);
        nearestM = std::min(nearestM, distanceTo(block.box, eye));
        if (!ranges.empty() && ranges.back().first + ranges.back().count == block.triangles.first)
            ranges.back().count += block.triangles.count;
        else
            ranges.push_back(block.triangles);
    }
    if (ranges.empty()) return;
    if (osgTraversal::seeksNearFar(visitor))
    {
        const osg::Matrixd& eyeFromLocal = *visitor.getModelViewMatrix();
        const auto view = osgTraversal::viewStateOf(visitor, eyeFromLocal,
                                                    osgTraversal::toGlm(*visitor.getProjectionMatrix()));
        osgTraversal::tellNearFar(visitor, box, view.cornerStretch,
                                  std::max(nearestM, 1.0) * osgTraversal::eyePerLocal(eyeFromLocal));
    }
    visitor.pushStateSet(_material->stateSet());
    visitor.pushStateSet(_maps);
    visitor.pushStateSet(_material->season() ? _seasonProgram : _plainProgram);
    const osg::ref_ptr<SurroundingsPart> part = new SurroundingsPart(_tile, _buffers, std::move(ranges), box);
    visitor.addDrawableAndDepth(part.get(), visitor.getModelViewMatrix(), static_cast<float>(nearestM));
    for (int i = 0; i < 3; ++i)
        visitor.popStateSet();
}

void Surroundings::releaseGLObjects(osg::State* state) const
{
    osg::Drawable::releaseGLObjects(state);
    _buffers->releaseGLObjects(state);
    for (const auto& stateSet : {_maps, _plainProgram, _seasonProgram})
        stateSet->releaseGLObjects(state);
}

} // namespace osgTerrainROAM
