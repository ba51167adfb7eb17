// SPDX-License-Identifier: Apache-2.0
// Entities that persons take over and give back.
#include <cmath>
#include <cstdio>

#include <foundation/Angle.h>

#include "simulation/player/ScenePerformer.h"
#include "simulation/scenario/ControllerKinds.h"

namespace simulation
{

void ScenePerformer::turn()
{
    for (std::size_t i = 0; i < _actors.size(); ++i)
    {
        if (!_actors[i].givenBack || !_external.isAboutToSit(i, timeS())) continue;
        _actors[i].motion.takeState(_published[i], timeS()); // from where it is seen
        _actors[i].givenBack.reset();
    }
    for (const std::size_t entity : _external.turn(timeS()))
    {
        for (const ActionDomain domain : {ActionDomain::longitudinal, ActionDomain::lateral})
            end(static_cast<int>(entity), domain);
        if (!_actors[entity].isExternal()) goOn(entity);
    }
}

/// The scenario goes on with what a person gave back.
void ScenePerformer::goOn(std::size_t entity)
{
    Actor& actor = _actors[entity];
    const EntityState left = actor.motion.state();
    actor.motion.goOn(actor.askedMps, timeS());
    if (EntityController* const mover = actor.mover()) mover->resume(left.speedMps);
    const GivenBack given(left, actor.motion.state(), timeS());
    char text[160];
    std::snprintf(text, sizeof text,
                  " goes on from %.1f m/s, to %.1f m/s where nothing else says so, %.1f m aside, in %.1f s",
                  left.speedMps, actor.askedMps, given.asideM(), given.lastsS());
    _external.note(left.name + text);
    actor.givenBack = given;
}

void ScenePerformer::leadGivenBack()
{
    for (std::size_t i = 0; i < _actors.size(); ++i)
    {
        if (!_actors[i].givenBack) continue;
        EntityState& state = _published[i];
        _actors[i].givenBack->lead(state, timeS());
        if (!_roads || !state.place) continue;
        if (const auto place = _roads->nearest(state.position, foundation::radiansOf(state.headingDeg)))
            state.place = place;
    }
}

/// Whether that was all: a manual controller gives the entity to a person who may sit there. Without one
/// InteractiveController stands still, as in esmini, and the scenario moves what another has.
bool ScenePerformer::asksPerson(const Controller& controller, const ExternalControl::Wish& wish, int actor)
{
    const bool isTaken = wish.longitudinal.value_or(false) || wish.lateral.value_or(false);
    if (!isTaken && !wish.longitudinal && !wish.lateral) return true;
    if (_external.askSeat(static_cast<std::size_t>(actor), isTaken)) return true;
    const bool standsStill = controller.played()->standsWithoutPerson;
    const std::string& name = _scenario->entities[static_cast<std::size_t>(actor)].name;
    char time[40];
    std::snprintf(time, sizeof time, " at %.2f s: ", timeS());
    if (isTaken)
        _external.note(name + ", controller " + controller.name + time + "nobody sits there, so " +
                       (standsStill ? "it stands still" : "the scenario moves it") +
                       "; --window lets a person drive, --inputs FILE plays what one did");
    return !standsStill;
}

} // namespace simulation
