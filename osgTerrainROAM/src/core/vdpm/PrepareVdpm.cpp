// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <osgTerrainROAM/core/vdpm/HeightFieldForest.h>
#include <osgTerrainROAM/core/vdpm/PrepareVdpm.h>
#include <osgTerrainROAM/core/vdpm/VdpmMesh.h>

namespace osgTerrainROAM::core
{

namespace
{

class PreparedVdpm : public PreparedTerrain
{
public:
    PreparedVdpm(std::shared_ptr<const RoamTile> tile, BoundedForest forest)
        : _tile(std::move(tile)), _forest(std::make_shared<const BoundedForest>(std::move(forest)))
    {
    }

    const RoamTile& tile() const override { return *_tile; }
    std::unique_ptr<TerrainMesh> newMesh() const override
    {
        return std::make_unique<VdpmMesh>(_tile, _forest);
    }
    std::uint32_t fewestTriangles() const override
    {
        return static_cast<std::uint32_t>(_forest->forest.rootFaces.size());
    }
    std::size_t memoryBytes() const override { return _forest->memoryBytes(); }

private:
    std::shared_ptr<const RoamTile> _tile;
    std::shared_ptr<const BoundedForest> _forest;
};

} // namespace

foundation::Result<PreparedPtr> prepareVdpm(std::shared_ptr<const RoamTile> tile)
{
    auto forest = heightFieldForest(tile->tile);
    if (!forest) return forest.error();
    return PreparedPtr(std::make_shared<PreparedVdpm>(std::move(tile), std::move(*forest)));
}

} // namespace osgTerrainROAM::core
