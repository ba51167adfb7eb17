// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <foundation/Result.h>

#include "worldmaking/map/StreetMap.h"

namespace worldmaking
{

/// Reads the streets of an OpenStreetMap extract: `.osm`, `.osm.gz` or `.osm.pbf`, by libosmium. The file is
/// read twice, so that only nodes of streets are kept. Memory: about 40 B a node and 300 B a way. A map may
/// have no street. Errors: a file that cannot be read or is damaged; streets none of which has nodes.
/// Source: the OpenStreetMap wiki, *Key:highway* and *Relation:restriction* (with a node as `via`).
foundation::Result<StreetMap> readOsm(const std::filesystem::path& file);

/// Reads the same from memory. `format`: osm, osm.gz or pbf. `name`: for errors.
foundation::Result<StreetMap> parseOsm(std::string_view bytes, const std::string& format,
                                       const std::string& name);

} // namespace worldmaking
