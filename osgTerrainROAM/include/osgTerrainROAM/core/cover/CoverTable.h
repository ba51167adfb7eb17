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

/// What covers the ground. `unknown`: what climate and heights say (osgTerrainROAM::Climate).
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
};
constexpr int kGroundKinds = 13;

/// Which kind each code of a land-cover raster means. A code that is not in it is unknown.
using CoverTable = std::map<int, GroundKind>;

/// ESA WorldCover 2020 and 2021: codes 10, 20 … 100 (Product User Manual v2.0, table 3).
CoverTable worldCoverTable();

/// CORINE Land Cover, the raster's codes 1 … 44 and the nomenclature's 111 … 523 (Kosztra and others, 2019).
CoverTable corineTable();

/// A plain text of lines `CODE = KIND`, a code being a number or a range FIRST-LAST; `#` starts a comment. `name` for messages.
/// Errors, with place "name:line": no such form, unknown kind (the known ones are named), code repeated or beyond ±1 000 000.
foundation::Result<CoverTable> parseCoverTable(std::string_view text, const std::string& name);

/// The built-in table "worldcover" or "corine", or a file of the form above.
foundation::Result<CoverTable> readCoverTable(const std::filesystem::path& nameOrFile);

} // namespace osgTerrainROAM::core
