// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "scenery/models/Model.h"
#include "scenery/models/cockpit/PanelView.h"
#include "scenery/models/cockpit/Readings.h"
#include "scenery/models/entities/EntityModel.h"

namespace scenery::models
{

/// How a part of an interior takes light.
enum class InteriorCoat
{
    outside, ///< as the vehicle's outside: bonnet, wing
    inside,  ///< in the shade of the roof
    dial,    ///< lit from within by night
    lamp,    ///< shines by itself
};

/// A rigid part. Frame: the entity's once placed. Units: metres.
struct InteriorPart
{
    std::string name;
    Model model;
    InteriorCoat coat = InteriorCoat::inside;
    std::function<glm::dmat4(const Readings&)> place{}; ///< pure; empty: it stays where it is made
    std::function<bool(const Readings&)> isShown{};     ///< empty: always
};

/// A flat mirror as it is looked at. Frame: the entity's. Units: metres.
struct InteriorMirror
{
    std::string name;
    glm::dvec3 lowLeft{0.0}, lowRight{0.0}, topLeft{0.0};
};

/// What somebody sees around who sits in a vehicle. Frame: the entity's: x forward, y left, z up; metres.
struct InteriorModel
{
    std::vector<InteriorPart> parts;
    std::vector<InteriorMirror> mirrors;
    std::optional<EntityRotor> propeller; ///< drawn as a disc where it turns fast
    double lookDownDeg = 0.0;             ///< of a head at rest, to have the instruments in sight
    PanelView panel;                      ///< of a head that reads them
};

/// Makes the interior of a vehicle of the shape, seen from `eye` (EntityModel::eye): a car's, or the cockpit
/// of an aircraft; nothing for what one does not sit inside of. Pure. Cost: some milliseconds.
std::optional<InteriorModel> makeInterior(const EntityShape& shape, const glm::dvec3& eye);

} // namespace scenery::models
