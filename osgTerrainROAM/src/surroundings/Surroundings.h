// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include <osg/Drawable>
#include <osg/StateSet>

#include <osgTerrainROAM/core/roam/RoamTile.h>

#include <osgTerrainROAM/TerrainMaterial>

#include "../view/GpuMesh.h"
#include "OuterMesh.h"

namespace osgUtil
{
class CullVisitor;
}

namespace osgTerrainROAM
{

/// The mesh of the surroundings with its copies in the graphics contexts.
/// Threads: any; each GpuMesh belongs to its context's draw thread.
class OuterBuffers
{
public:
    explicit OuterBuffers(OuterMesh mesh) : _mesh(std::move(mesh)) {}

    const OuterMesh& mesh() const { return _mesh; }
    void draw(osg::State& state, const std::vector<core::IndexRange>& ranges);
    /// Releases the buffers of one context, or (nullptr) of all.
    void releaseGLObjects(osg::State* state);

private:
    const OuterMesh _mesh;
    std::mutex _mutex; ///< guards the map
    std::map<unsigned int, std::unique_ptr<GpuMesh>> _copies;
};

/// Draws made-up ground from the border of a tile's data to the horizon, with the tile's own light, colours
/// and haze.
/// It has no bounds and no triangles for functors: home positions, intersections and ground queries see the
/// data alone.
/// Cull: blocks of triangles, by the frustum. Near and far planes: as RoamDrawable.
/// Ownership: shares tile and material. Threads: culls and draws from any threads.
/// Cost: 0.3 s to make, 5 MB; some 20 000 triangles.
class Surroundings : public osg::Drawable
{
public:
    Surroundings(std::shared_ptr<const core::RoamTile> tile, TerrainMaterial* material);

    using osg::Drawable::accept;
    void accept(osg::NodeVisitor& visitor) override;
    bool supports(const osg::PrimitiveFunctor&) const override { return false; }
    osg::BoundingBox computeBoundingBox() const override { return {}; }
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~Surroundings() override = default;

private:
    void cull(osgUtil::CullVisitor& visitor);
    void addMaps(const OuterGround& ground, const OuterAxis& columns, const OuterAxis& rows);

    std::shared_ptr<const core::RoamTile> _tile;
    osg::ref_ptr<TerrainMaterial> _material;
    std::shared_ptr<OuterBuffers> _buffers;
    osg::ref_ptr<osg::StateSet> _maps;                         ///< laid over the material's
    osg::ref_ptr<osg::StateSet> _plainProgram, _seasonProgram; ///< one of them over that
};

} // namespace osgTerrainROAM
