// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace simulation
{

/// The inputs of a road vehicle, as places in DynamicVehicle::inputs().
enum class RoadInput
{
    steering,  ///< -1…1 of the lock, positive to the left
    throttle,  ///< 0…1
    brake,     ///< 0…1
    handbrake, ///< 0…1
    clutch,    ///< 0…1: pressed; without effect in an automatic
    gear,      ///< -1 reverse, 0 neutral, 1 and up: the gear, or any forward gear of an automatic
    indicator, ///< 1 left, -1 right, 0 off
    lights,    ///< head lamps: 1 on, -1 off, 0 by themselves in the dark
    count
};

inline constexpr std::size_t kRoadInputCount = static_cast<std::size_t>(RoadInput::count);

inline constexpr std::array<std::string_view, kRoadInputCount> kRoadInputNames{
    "steering", "throttle", "brake", "handbrake", "clutch", "gear", "indicator", "lights"};

using RoadInputs = std::array<double, kRoadInputCount>;

/// One input within its range; NaN as 0. A gear is rounded.
double inputOf(const RoadInputs& inputs, RoadInput input);

} // namespace simulation
