// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/cockpit/InteriorModel.h"
#include "scenery/models/roads/RoadModelParts.h"

/// What the interiors of aircraft and cars share.
namespace scenery::models
{

inline constexpr glm::vec3 kDashboard(0.26F, 0.26F, 0.28F), kPanelGrey(0.40F, 0.41F, 0.42F),
    kLining(0.46F, 0.45F, 0.43F), kSeam(0.15F, 0.15F, 0.16F);

/// From a panel's frame (x to the right, y up, z to the eye) to the entity's. `middle`: its origin.
glm::dmat4 upright(const glm::dvec3& middle);

/// Moves a part by a vector that does not change.
inline std::function<glm::dmat4(const Readings&)> movedBy(const glm::dvec3& shift)
{
    glm::dmat4 moved(1.0);
    moved[3] = glm::dvec4(shift, 1.0);
    return [moved](const Readings&) { return moved; };
}

/// Adds a square bar between two points, `thickM` on each side; a pillar. Precondition: a part has begun.
void addPost(ModelBuilder& builder, const glm::dvec3& from, const glm::dvec3& to, double thickM);

/// A mirror of a size about a middle that shows `eye` what lies towards `seen` (any length) from it.
InteriorMirror mirrorTowards(const std::string& name, const glm::dvec3& middle, const glm::dvec2& sizeM,
                             const glm::dvec3& eye, const glm::dvec3& seen);

/// Adds the mirror and its housing, which is a little larger.
void addMirror(InteriorModel& interior, const InteriorMirror& mirror);

/// Makes the interior of a car, a van, a bus or a lorry; and of an aircraft.
InteriorModel makeCarInterior(const EntityShape& shape, const glm::dvec3& eye);
InteriorModel makeAircraftCockpit(const EntityShape& shape, const glm::dvec3& eye);

} // namespace scenery::models
