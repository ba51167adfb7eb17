// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <glm/glm.hpp>

namespace simulation
{

class ActionScene;

/// Moves an entity in place of the actions of its scenario: a controller of its speed, its pedals, a vehicle
/// with physics. While it has the entity, it hears what the scenario asks for.
/// Determinism: what it does depends on the scene and on what it heard alone. Threads: one.
class EntityController
{
public:
    virtual ~EntityController() = default;

    /// Moves the entity on to the time of the scene. Those without a controller have moved already.
    virtual void move(ActionScene& scene, int actor) = 0;

    /// Hears which speed the scenario asks for. Units: m/s.
    virtual void askForSpeed(double /*speedMps*/) {}

    /// Hears beside which place of its way the scenario wants it to be; nothing: on its own way again.
    virtual void askForPlace(const std::optional<glm::dvec3>& /*place*/) {}

    /// Goes on from this speed, after somebody else had the entity.
    virtual void resume(double /*speedMps*/) {}
};

} // namespace simulation
