// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <osgTerrainROAM/core/features/GroundFeature.h>

namespace osgTerrainROAM::core
{

/// Returns features and their report as bytes, for featuresIn(). Numbers are the machine's.
std::string bytesOf(const FeatureSet& set);

/// Absent: bytesOf() did not write them.
std::optional<FeatureSet> featuresIn(std::string_view bytes);

} // namespace osgTerrainROAM::core
