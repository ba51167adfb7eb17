// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgMultiTriangulation/core/follow/SampledSurface.h>

#include <osgMultiTriangulation/OpenMultiTriangulation>

namespace osgMultiTriangulation
{

namespace
{

using osgTerrainROAM::core::HeightField;
using osgTerrainROAM::core::PlacedTile;
using osgTerrainROAM::core::RoamTile;

HeightField fieldOf(core::SampledSurface sampled, const std::string& name)
{
    HeightField field;
    field.name = name;
    field.columns = sampled.columns;
    field.rows = sampled.rows;
    field.heightsM = std::move(sampled.heights);
    field.spacingEastM = sampled.spacingX;
    field.spacingNorthM = sampled.spacingY;
    if (std::ranges::count(sampled.isThere, 0) > 0)
        field.mask = osgTerrainROAM::core::SampleMask(sampled.isThere, field.columns, field.rows);
    return field;
}

/// Widens the box of the tile, whose samples may lie below a peak between them.
osg::BoundingBox boxOf(osg::BoundingBox box, float lowest, float highest)
{
    box.zMin() = std::min(box.zMin(), lowest - 0.01f);
    box.zMax() = std::max(box.zMax(), highest + 0.01f);
    return box;
}

} // namespace

foundation::Result<MtTerrain> openMultiTriangulation(const std::filesystem::path& path,
                                                     const MtDrawableSettings& settings,
                                                     const osgTerrainROAM::core::RoamFile& look)
{
    auto file = core::MtFile::open(path);
    if (!file) return file.error();
    auto sampled = core::sampleSurface(*file);
    if (!sampled) return sampled.error();
    const float lowest = sampled->lowest, highest = sampled->highest;
    const auto tile = std::make_shared<RoamTile>(PlacedTile(fieldOf(std::move(*sampled), path.string())));
    core::ZoneSettings zone;
    zone.memoryBytes = settings.memoryBytes;
    zone.mostBytesPerS = settings.mostBytesPerS;
    auto follower = core::SurfaceFollower::open(std::move(*file), zone, tile->tile.frame().vertexStepM());
    if (!follower) return follower.error();
    auto terrain = osgTerrainROAM::makeTerrain(look, tile);
    if (!terrain) return terrain.error();
    MtTerrain made{*terrain, nullptr};
    osgTerrainROAM::RoamDrawable& ground = *made.terrain->drawable();
    made.drawable = new MtDrawable(std::move(*follower), *made.terrain,
                                   boxOf(ground.getBoundingBox(), lowest, highest), settings.waits);
    made.drawable->takeLook(*made.terrain->material());
    ground.setNodeMask(0);
    made.terrain->addChild(made.drawable);
    made.terrain->setName(path.string());
    return made;
}

} // namespace osgMultiTriangulation
