// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <osgTerrainROAM/core/features/GroundFeature.h>

namespace osgTerrainROAM::core
{

/// The value of a feature's attribute; empty when it has none of that name.
using TagLookup = std::function<std::string(const char* name)>;

/// Determines the style of a feature from its attributes, or else from its layer's name.
/// - `kind` = road | river | field | runway (also taxiway, track, stream, meadow, orchard, …);
/// - OpenStreetMap: highway, waterway, natural = water, landuse, aeroway, with lanes, surface, crop, ref;
/// - layer names that contain road, street, highway, river, water, stream, field, crop, farm, runway.
/// `width` (as foundation::metresOfTag() reads it) and `lanes` override the kind's defaults. Nothing: of no
/// known kind.
std::optional<FeatureStyle> featureStyle(const TagLookup& tag, const std::string& layer);

/// Names a feature of no known kind: its first tag among those that classify in OpenStreetMap.
std::string unknownName(const TagLookup& tag);

/// Reads a length as foundation::metresOfTag() does; nothing outside 0.1 … 5000 m.
std::optional<double> metresIn(const std::string& text);

/// The value of `key` in OGR's hstore text of further tags: "width"=>"7","surface"=>"gravel".
std::string hstoreValue(const std::string& text, const std::string& key);

} // namespace osgTerrainROAM::core
