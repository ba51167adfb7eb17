// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "simulation/scenario/Scenario.h"

namespace simulation
{

/// The traffic around a person who drives or flies freely.
struct SessionTraffic
{
    /// Whoever flies sees farther. Source: chosen.
    static constexpr double kAroundVehicleM = 400.0, kAroundAircraftM = 1500.0;

    double perKm = 0.0;               ///< vehicles a kilometre of street, both directions together
    double radiusM = kAroundVehicleM; ///< around the person, within which there are vehicles

    /// After the begin vehicles appear beyond this share of the radius alone, and leave beyond the whole.
    static constexpr double kAppearShare = 0.85;

    /// Source: chosen; at 50 km/h they are flows of 200, 500 and 1250 vehicles an hour, flow = density times
    /// speed.
    static constexpr double kLightPerKm = 4.0, kMediumPerKm = 10.0, kDensePerKm = 25.0;
    static constexpr double kMostPerKm = 60.0;
    static constexpr int kMostVehicles = 120;
};

/// Returns vehicles a kilometre of street of a word (none, light, medium, dense) or of a number from 0 to
/// kMostPerKm; nothing: it is neither.
std::optional<double> trafficDensity(std::string_view text);

/// Adds to a scenario, behind its other traffic, cars and vans that keep the rules, around an entity. It does
/// nothing for a density of 0.
void addTraffic(Scenario& scenario, const std::string& around, const SessionTraffic& traffic);

} // namespace simulation
