// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include <glm/vec2.hpp>

namespace foundation
{

/// Returns the height of a surface at a place of a plan; nothing beyond its data.
/// Frame: x east and y north, or the plan of a road network; who takes it says which datum heights count
/// from.
/// Units: metres.
using HeightInPlan = std::function<std::optional<double>(const glm::dvec2& plan)>;

/// Returns the height of a surface at a place on the Earth (WGS84); nothing beyond its data.
/// Units: degrees; metres above the datum that who takes it names.
using HeightOnEarth = std::function<std::optional<double>(double latitudeDeg, double longitudeDeg)>;

} // namespace foundation
