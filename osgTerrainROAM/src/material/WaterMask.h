// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "SkyVisibility.h"

namespace osgTerrainROAM
{

/// Estimates standing water from heights alone: 0 is land, 255 water; land next to water has values in
/// between, so that the shore can be drawn finer than the samples.
/// - sea: connected samples at or below sea level, at least kLeastSamples of them;
/// - lake: connected samples of exactly equal height, at least kLeastSamples, that no more than 4 % of their
///   rim lies below (files flatten standing water; a terrace has a lower side).
/// `hasLakes`: else there is only sea. NaN heights are neither.
constexpr int kLeastWaterSamples = 100;
std::vector<std::uint8_t> waterMask(const MapField& heights, const MapGrid& grid, double seaLevelM,
                                    bool hasLakes);

} // namespace osgTerrainROAM
