// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simulation/player/EntityMotion.h"
#include "simulation/player/ExternalMotion.h"
#include "simulation/player/GivenBack.h"
#include "simulation/player/Seat.h"
#include "simulation/player/actions/RunningAction.h"
#include "simulation/player/controllers/PedalDrive.h"
#include "simulation/player/controllers/SpeedController.h"

namespace simulation
{

/// A vehicle with physics in place of an entity's actions, and who drives it.
struct Attachment
{
    std::shared_ptr<ExternalMotion> motion; ///< null: the entity moves by its actions
    std::optional<Controller> controller;   ///< absent: attached for the whole play
    bool isLongitudinal = true, isLateral = true;
    bool isByPerson = false;

    /// Whether it has hold of a domain of the motion.
    bool holds(ActionDomain domain) const
    {
        return motion && (domain == ActionDomain::longitudinal ? isLongitudinal : isLateral);
    }
};

/// An entity while its scenario is played: where it is, and what moves it. One of these moves it, the first
/// that there is: a vehicle with physics (a person's before a controller's), its pedals, a controller of its
/// speed, its actions.
struct Actor
{
    /// `roads`: null without a road network.
    Actor(const ScenarioObject& object, const SceneFrame& frame, const RoadScene* roads)
        : motion(object, frame, roads), controllers(object.controllers)
    {
    }

    bool isExternal() const { return vehicle.motion != nullptr; }
    bool isByPerson() const { return vehicle.isByPerson; }

    /// What moves it in place of its actions; null: nothing does.
    EntityController* mover() const
    {
        if (isExternal()) return vehicle.motion.get();
        return pedals ? pedals.get() : speed.get();
    }

    /// Whether what moves it has hold of its speed, so that actions have not.
    bool isSpeedHeld() const { return isExternal() ? vehicle.isLongitudinal : mover() != nullptr; }

    EntityMotion motion; ///< its state, whatever moves it, and how actions move it

    bool isAbsent = false;                  ///< not added yet, or deleted
    bool isHidden = false;                  ///< not in pictures
    std::map<std::string, LampState> lamps; ///< that actions have switched

    std::vector<Controller> controllers;      ///< that it has been assigned, the last one last
    std::unique_ptr<EntityController> speed;  ///< the active one; null: actions set the speed
    Controls controls;                        ///< that actions have taken over
    std::unique_ptr<EntityController> pedals; ///< null: none of them changes the speed

    Attachment vehicle;                 ///< that moves it
    Attachment waiting;                 ///< for the begin of the play
    Attachment yielded;                 ///< to a person, without motion
    std::shared_ptr<Seat> seat;         ///< null: nobody may sit there
    double askedMps = 0.0;              ///< by the scenario while a person has it, or before
    std::size_t impactsTold = 0;        ///< of its vehicle
    std::optional<GivenBack> givenBack; ///< on its way back to the scenario's
};

} // namespace simulation
