// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <osgTerrainROAM/core/features/ShapeImport.h>

namespace osgTerrainROAM::core
{

/// Returns shapes as bytes, for shapesIn(). Numbers are the machine's.
std::string bytesOf(const ShapeSet& set);

/// Absent: bytesOf() did not write them.
std::optional<ShapeSet> shapesIn(std::string_view bytes);

} // namespace osgTerrainROAM::core
