// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osgTerrainROAM/core/LoadTerrain.h>

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
    else if (!description.roads.empty())
        options.gridExponent = gridExponentFor(*field, kRoadSpacingM);
    return PlacedTile(std::move(*field), options);
}

} // namespace osgTerrainROAM::core
