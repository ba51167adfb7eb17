// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>

#include <foundation/Result.h>

#include "worldmaking/land/Houses.h"

namespace worldmaking
{

/// Writes houses as a GeoPackage: the layer `buildings` of outlines and the layer `towers` of points, with
/// the tags of Simple 3D Buildings, those that rules have chosen included. Errors: as MapFile::finish().
foundation::Outcome writeHouses(std::span<const House> houses, const std::filesystem::path& file);

} // namespace worldmaking
