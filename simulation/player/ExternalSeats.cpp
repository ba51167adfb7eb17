// SPDX-License-Identifier: Apache-2.0
// Persons in entities: who takes over, who gives back, and what is told of it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include <foundation/Angle.h>

#include "simulation/player/ExternalControl.h"

namespace simulation
{

namespace
{

constexpr double kLongS = 1e9; ///< after which every speed action is over

/// What a person should know of an impact beside textOf(): how hard it was, and on which course.
std::string blowText(const Impact& impact)
{
    constexpr double kKmhPerMps = 3.6;
    const double course = 90.0 - foundation::degreesOf(std::atan2(impact.direction.y, impact.direction.x));
    char text[100];
    std::snprintf(text, sizeof text, ", closing at %.0f km/h, on a course of %03.0f°",
                  kKmhPerMps * impact.closingMps, std::fmod(course + 360.0, 360.0));
    return text;
}

} // namespace

std::string ExternalControl::nameAt(std::size_t entity, double timeS) const
{
    char time[40];
    std::snprintf(time, sizeof time, " at %.2f s: ", timeS);
    return _place.scenario.entities[entity].name + time;
}

void ExternalControl::seat(std::size_t entity, std::shared_ptr<Seat> seat)
{
    at(entity).seat = std::move(seat);
    _told.resize(_place.actors.size());
}

bool ExternalControl::askSeat(std::size_t entity, bool isTaken)
{
    if (!at(entity).seat) return false;
    at(entity).seat->ask(isTaken);
    return true;
}

bool ExternalControl::isAboutToSit(std::size_t entity, double timeS) const
{
    const Actor& actor = at(entity);
    return actor.seat && !actor.isByPerson() && !actor.isAbsent && actor.seat->isWanted(timeS);
}

foundation::Outcome ExternalControl::sitDown(std::size_t entity, double timeS)
{
    Actor& actor = at(entity);
    EntityMotion& own = actor.motion;
    const EnvironmentState environment = _place.environment();
    auto made = actor.seat->take(_place.scenario.entities[entity],
                                 {own.state(), own.isAirborne(), timeS, environment, {}});
    if (!made) return made.error();
    Attachment& slot = actor.vehicle;
    actor.yielded = slot.controller
                        ? Attachment{nullptr, slot.controller, slot.isLongitudinal, slot.isLateral}
                        : Attachment{};
    actor.askedMps = own.askedSpeedAt(kLongS);
    slot = {std::move(*made), std::nullopt, true, true, true};
    actor.impactsTold = 0;
    own.takeState(slot.motion->state(), timeS);
    return foundation::success();
}

void ExternalControl::standUp(std::size_t entity, double timeS)
{
    Actor& actor = at(entity);
    if (const std::string note = actor.vehicle.motion->note(); !note.empty())
        _notes.push_back(_place.scenario.entities[entity].name + " " + note);
    actor.seat->leave(timeS);
    actor.vehicle = {};
    const Attachment yielded = std::exchange(actor.yielded, {});
    if (!yielded.controller) return;
    wish(entity, *yielded.controller, {yielded.isLongitudinal, yielded.isLateral}, timeS);
}

std::vector<std::size_t> ExternalControl::turn(double timeS)
{
    std::vector<std::size_t> turned;
    for (std::size_t i = 0; i < _place.actors.size(); ++i)
    {
        const Actor& actor = at(i);
        if (actor.isByPerson() ? actor.seat->isWanted(timeS) : !isAboutToSit(i, timeS)) continue;
        if (actor.isByPerson())
        {
            standUp(i, timeS);
            _notes.push_back(nameAt(i, timeS) + "the person gives it back");
        }
        else if (const auto seated = sitDown(i, timeS); !seated)
        {
            actor.seat->refuse(seated.error());
            _notes.push_back(nameAt(i, timeS) + "nobody can take over: " + seated.error().message());
            continue;
        }
        else
            _notes.push_back(nameAt(i, timeS) + "the person takes over");
        turned.push_back(i);
    }
    return turned;
}

void ExternalControl::vanish(std::size_t entity, double timeS)
{
    if (Actor& actor = at(entity); actor.isByPerson())
    {
        actor.seat->leave(timeS);
        actor.seat->refuse(
            {_place.scenario.entities[entity].name, "it is not there any more", "begin again"});
        actor.vehicle = {};
        actor.yielded = {};
    }
    release(entity, timeS);
}

/// A controller that is activated or deactivated while a person has its entity.
void ExternalControl::wishBehindPerson(std::size_t entity, const Controller& controller, const Wish& wish)
{
    Attachment& slot = at(entity).yielded;
    const bool isSame = slot.controller && slot.controller->name == controller.name &&
                        slot.controller->objectName == controller.objectName;
    const bool longitudinal = wish.longitudinal.value_or(isSame && slot.isLongitudinal);
    const bool lateral = wish.lateral.value_or(isSame && slot.isLateral);
    slot = longitudinal || lateral ? Attachment{nullptr, controller, longitudinal, lateral} : Attachment{};
}

std::vector<std::pair<int, int>> ExternalControl::touches() const
{
    std::vector<std::pair<int, int>> touches;
    for (std::size_t i = 0; i < _place.actors.size(); ++i)
        if (at(i).isByPerson())
            for (const int other : at(i).vehicle.motion->touched())
                touches.emplace_back(static_cast<int>(i), other);
    return touches;
}

void ExternalControl::tell()
{
    for (std::size_t i = 0; i < _told.size(); ++i)
    {
        EntityTold& told = _told[i];
        told = {};
        Actor& actor = at(i);
        const Attachment& attachment = actor.vehicle;
        if (!attachment.motion) continue;
        if (attachment.controller) told.drivenBy = attachment.controller->kind();
        if (!attachment.isByPerson) continue;
        told.drivenBy = "person";
        const std::span<const Impact> impacts = attachment.motion->impacts();
        for (; actor.impactsTold < impacts.size(); ++actor.impactsTold)
        {
            const Impact& impact = impacts[actor.impactsTold];
            _notes.push_back("impact: " + _place.scenario.entities[i].name + " " +
                             textOf(impact, attachment.motion->begunS()) + blowText(impact) +
                             (impact.hasGiven ? ", which gave way" : ""));
            if (told.blow && told.blow->closingMps >= impact.closingMps) continue;
            const std::string kind(factsOf(impact.kind).name);
            told.blow = {impact.speedMps, impact.closingMps,
                         std::atan2(impact.direction.y, impact.direction.x),
                         impact.name.empty() ? kind : impact.name};
        }
    }
}

} // namespace simulation
