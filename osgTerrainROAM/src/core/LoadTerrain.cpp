// SPDX-License-Identifier: Apache-2.0
#include <osgTerrainROAM/core/LoadTerrain.h>

namespace osgTerrainROAM::core
{

viewlod::Result<RoamFile> describeTerrain(const std::filesystem::path& file, const DemImportOptions& import)
{
    if (file.extension() == ".roam") return readRoamFile(file);
    RoamFile description;
    description.dem = file;
    description.import = import;
    return description;
}

viewlod::Result<PlacedTile> loadTile(const RoamFile& description)
{
    auto field = importDem(description.dem, description.import);
    if (!field) return field.error();
    const bool curved = description.placement == Placement::curved && field->net.has_value();
    if (curved && description.origin) return PlacedTile(std::move(*field), *description.origin);
    return PlacedTile(std::move(*field), description.placement);
}

} // namespace osgTerrainROAM::core
