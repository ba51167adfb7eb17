// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include <foundation/Result.h>

namespace osgTerrainROAM::core
{

/// The kind of cover of the ground. `unknown`: climate and height decide (osgTerrainROAM::Climate).
enum class GroundKind : std::uint8_t
{
    unknown,
    rock,
    soil,
    dryGrass,
    meadow,
    shrub,
    forest,
    sand,
    snow,
    water,
    crop,
    urban,
    wetland,
    garden, ///< between houses that stand as models: lawns, beds, hedges, trees
    yard,   ///< between buildings that stand as models: paving, gravel, a little green
};
constexpr int kGroundKinds = 15;

/// The kind that each code of a land-cover raster means. Codes without an entry are unknown.
using CoverTable = std::map<int, GroundKind>;

/// ESA WorldCover 2020 and 2021: codes 10, 20 … 100 (Product User Manual v2.0, table 3); and 51, gardens,
/// and 52, yards, which are ours.
CoverTable worldCoverTable();

/// CORINE Land Cover, the raster's codes 1 … 44 and the nomenclature's 111 … 523 (Kosztra and others, 2019).
CoverTable corineTable();

/// Parses text of lines `CODE = KIND`; a code is a number or a range FIRST-LAST, `#` starts a comment.
/// `name`: for messages. Errors, with place "name:line": malformed line, unknown kind (the message lists the
/// known ones), code repeated or beyond ±1 000 000.
foundation::Result<CoverTable> parseCoverTable(std::string_view text, const std::string& name);

/// Returns the built-in table "worldcover" or "corine", or reads a file for parseCoverTable().
foundation::Result<CoverTable> readCoverTable(const std::filesystem::path& nameOrFile);

} // namespace osgTerrainROAM::core
