// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <osgTerrainROAM/core/blocks/DecimatedMesh.h>
#include <osgTerrainROAM/core/blocks/VipmMesh.h>
#include <osgTerrainROAM/core/method/PrepareTerrain.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>
#include <osgTerrainROAM/core/vdpm/PrepareVdpm.h>

namespace osgTerrainROAM::core
{

namespace
{

/// ROAM: the bounds of the split vertices are the tile's, or those of patches.
class PreparedRoam : public PreparedTerrain
{
public:
    PreparedRoam(SplitBounds bounds, Driver driver)
        : _bounds(std::move(bounds)), _driver(driver), _revision(_bounds.tile().revision())
    {
    }

    const RoamTile& tile() const override { return _bounds.tile(); }

    std::unique_ptr<TerrainMesh> newMesh() const override
    {
        // The bounds of patches are those of the time when they were measured.
        const bool isStale = _bounds.patchExponent() > 0 && tile().revision() != _revision;
        return std::make_unique<RoamMesh>(isStale ? _bounds.remade() : _bounds, _driver);
    }

    std::uint32_t fewestTriangles() const override { return 2; }
    std::size_t memoryBytes() const override { return _bounds.memoryBytes(); }

private:
    SplitBounds _bounds;
    Driver _driver;
    std::uint64_t _revision;
};

} // namespace

foundation::Result<PreparedPtr> prepareTerrain(std::shared_ptr<const RoamTile> tile,
                                               const MethodRequest& request, const std::string& owner)
{
    if (const auto able = checkMethod(request, owner); !able) return able.error();
    if (const auto able = checkMethod(request.method, *tile, owner); !able) return able.error();
    const auto roamBy = [&](Driver driver)
    {
        return PreparedPtr(
            std::make_shared<PreparedRoam>(SplitBounds(std::move(tile), request.patchExponent), driver));
    };
    switch (request.method)
    {
    case Method::roam:
        break;
    case Method::roamWalk:
        return roamBy(Driver::walk);
    case Method::roamQueue:
        return roamBy(Driver::queue);
    case Method::vdpm:
        return prepareVdpm(std::move(tile));
    case Method::regularDecimation:
        return PreparedPtr(std::make_shared<PreparedDecimation>(std::move(tile)));
    case Method::vipmLocked:
        return PreparedPtr(std::make_shared<PreparedVipm>(std::move(tile), VipmBorders::locked));
    case Method::vipmOverlapping:
        return PreparedPtr(std::make_shared<PreparedVipm>(std::move(tile), VipmBorders::overlapping));
    }
    return roamBy(Driver::wheel);
}

} // namespace osgTerrainROAM::core
