// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <foundation/WholeText.h>

#include <osgTerrainROAM/core/LoadTerrain.h>
#include <osgTerrainROAM/core/edit/EditFile.h>
#include <osgTerrainROAM/core/edit/ShapeGround.h>

namespace osgTerrainROAM::core
{

/// Samples beside roads, where nothing else is told: beds, cuttings and embankments take no finer ones.
constexpr double kRoadSpacingM = 2.0;

int gridExponentFor(const HeightField& field, double spacingM)
{
    const double coarsestM = std::max(field.spacingEastM, field.spacingNorthM);
    constexpr double kSlack = 1.01; // map projections distort lengths a little
    int exponent = 0;
    while (std::ldexp(coarsestM, -exponent) > kSlack * spacingM &&
           ((field.tileSide() - 1) << (exponent + 1)) + 1 <= TileGrid::kMostSide)
        ++exponent;
    return exponent;
}

foundation::Result<RoamFile> describeTerrain(const std::filesystem::path& file,
                                             const DemImportOptions& import)
{
    if (file.extension() == ".roam") return readRoamFile(file);
    std::error_code failed;
    if (const auto world = file / "world.roam"; std::filesystem::exists(world, failed))
        return readRoamFile(world);
    RoamFile description;
    description.dems = {file};
    description.import = import;
    return description;
}

foundation::Result<PlacedTile> loadTile(const RoamFile& description)
{
    auto field = importDems(description.dems, description.import);
    if (!field) return field.error();
    PlacedTileOptions options{.placement = description.placement, .origin = description.origin};
    if (description.finestSpacingM)
        options.gridExponent = gridExponentFor(*field, *description.finestSpacingM);
    else if (!description.roads.empty() || !description.earthworks.empty())
        options.gridExponent = gridExponentFor(*field, kRoadSpacingM);
    return PlacedTile(std::move(*field), options);
}

foundation::Result<std::shared_ptr<RoamTile>> loadRoamTile(const RoamFile& description,
                                                           const foundation::KeptResults* kept)
{
    auto placed = loadTile(description);
    if (!placed) return placed.error();
    auto tile = std::make_shared<RoamTile>(std::move(*placed), kept);
    if (description.edits.empty())
    {
        if (const auto shaped = shapeGround(description.earthworks, tile); !shaped) return shaped.error();
        return tile;
    }
    const auto source = editSourceOf(description);
    if (!source) return source.error();
    if (const auto read = readEdits(*tile, *source, description.edits); !read) return read.error();
    return tile;
}

foundation::Result<std::uint64_t> editSourceOf(const RoamFile& description)
{
    if (description.roads.empty()) return markOf({});
    constexpr std::uintmax_t kMostBytes = std::uintmax_t{4} << 30;
    const auto roads = foundation::readWholeText(description.roads, kMostBytes);
    if (!roads) return roads.error();
    std::string place = description.roadsOnGround ? "ground" : "file";
    if (const auto& origin = description.roadsOrigin)
        for (const double value : {origin->latitudeDeg, origin->longitudeDeg, origin->headingDeg})
            place += ' ' + std::to_string(value);
    std::uint64_t mark = markOf(place, markOf(*roads));
    for (const auto& file : description.earthworks)
    {
        const auto works = foundation::readWholeText(file, kMostBytes);
        if (!works) return works.error();
        mark = markOf(*works, mark);
    }
    return mark;
}

} // namespace osgTerrainROAM::core
