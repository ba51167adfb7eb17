// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <foundation/Result.h>

#include "pmtool/polygons/PolygonSet.h"

namespace pmtool
{

/// Reads the `v`, `vt` and `f` lines of a Wavefront .obj; faces may have any number of corners, other lines
/// are ignored. A face is one contour: the format has no holes. `file` stands in messages.
/// Errors: a line that is not of the format, an index without a vertex, a number that is not finite; the line
/// is named.
foundation::Result<PolygonSet> parseObj(std::string_view text, const std::string& file);

/// Reads the Polygon and MultiPolygon geometries of a GeoJSON text (RFC 7946, section 3.1); other geometries
/// and all properties are ignored. The first ring of a polygon is its outer contour, further rings are holes.
/// Two numbers are x and y, a third one is z; they are taken as plane coordinates, also where they are
/// degrees.
/// Errors: no JSON, no GeoJSON object, rings of fewer than 3 corners, numbers that are not finite; the
/// feature is named.
foundation::Result<PolygonSet> parseGeoJson(std::string_view text, const std::string& file);

/// Reads a file of either format, told by its extension: .obj, .geojson, .json. Errors: no such file, another
/// extension, and those of the format.
foundation::Result<PolygonSet> readPolygons(const std::filesystem::path& file);

} // namespace pmtool
