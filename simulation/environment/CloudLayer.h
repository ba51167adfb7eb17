// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <foundation/Result.h>

namespace simulation
{

/// What the clouds of a layer are like.
enum class CloudKind : std::uint8_t
{
    cumulus,       ///< heaps, each by itself, flat below
    stratocumulus, ///< rolls and lumps with gaps
    stratus,       ///< a sheet without form
    cirrus         ///< thin streaks of ice
};

/// A layer of clouds. Units: metres above the ground at the scene's origin.
struct CloudLayer
{
    CloudKind kind = CloudKind::cumulus;
    int oktas = 0;                    ///< eighths of the sky that it covers, 0 … 8
    double baseM = 0.0, topM = 100.0; ///< top above base by 50 m or more

    bool operator==(const CloudLayer&) const = default;
};

/// As many layers are drawn.
inline constexpr std::size_t kMostCloudLayers = 3;

/// Reads layers that are parted by ';', each OKTAS KIND BASE TOP as in "4 cumulus 1200 2000", sorted by base;
/// "none": no cloud. Errors: what is none of these, a number out of range, layers that share heights, more
/// than kMostCloudLayers. `place`: for messages.
foundation::Result<std::vector<CloudLayer>> readCloudLayers(std::string_view text, std::string_view place);

/// Returns the layer that a cover without a height usually has: cumulus from 1200 m up to 4 oktas,
/// stratocumulus from 1000 m up to 7, stratus from 600 m, lower where something falls from it. Nothing at 0.
std::vector<CloudLayer> defaultClouds(int oktas, bool falls);

} // namespace simulation
