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
    _seats[entity] = std::move(seat);
    _told.resize(_seats.size());
}

bool ExternalControl::askSeat(std::size_t entity, bool isTaken)
{
    if (!_seats[entity]) return false;
    _seats[entity]->ask(isTaken);
    return true;
}

bool ExternalControl::isAboutToSit(std::size_t entity, double timeS) const
{
    return _seats[entity] && !isByPerson(entity) && _place.isThere(entity) && _seats[entity]->isWanted(timeS);
}

foundation::Outcome ExternalControl::sitDown(std::size_t entity, double timeS)
{
    EntityMotion& own = _place.motions[entity];
    const EnvironmentState environment = _place.environment();
    auto made = _seats[entity]->take(_place.scenario.entities[entity],
                                     {own.state(), own.isAirborne(), timeS, environment, {}});
    if (!made) return made.error();
    Attachment& slot = _external[entity];
    _yielded[entity] = slot.controller
                           ? Attachment{nullptr, slot.controller, slot.isLongitudinal, slot.isLateral}
                           : Attachment{};
    _askedMps[entity] = own.askedSpeedAt(kLongS);
    slot = {std::move(*made), std::nullopt, true, true, true};
    _impactsTold[entity] = 0;
    own.takeState(slot.motion->state(), timeS);
    return foundation::success();
}

void ExternalControl::standUp(std::size_t entity, double timeS)
{
    if (const std::string note = _external[entity].motion->note(); !note.empty())
        _notes.push_back(_place.scenario.entities[entity].name + " " + note);
    _seats[entity]->leave(timeS);
    _external[entity] = {};
    const Attachment yielded = std::exchange(_yielded[entity], {});
    if (!yielded.controller) return;
    wish(entity, *yielded.controller, {yielded.isLongitudinal, yielded.isLateral}, timeS);
}

std::vector<std::size_t> ExternalControl::turn(double timeS)
{
    std::vector<std::size_t> turned;
    for (std::size_t i = 0; i < _seats.size(); ++i)
    {
        if (isByPerson(i) ? _seats[i]->isWanted(timeS) : !isAboutToSit(i, timeS)) continue;
        if (isByPerson(i))
        {
            standUp(i, timeS);
            _notes.push_back(nameAt(i, timeS) + "the person gives it back");
        }
        else if (const auto seated = sitDown(i, timeS); !seated)
        {
            _seats[i]->refuse(seated.error());
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
    if (isByPerson(entity))
    {
        _seats[entity]->leave(timeS);
        _seats[entity]->refuse(
            {_place.scenario.entities[entity].name, "it is not there any more", "begin again"});
        _external[entity] = {};
        _yielded[entity] = {};
    }
    release(entity, timeS);
}

/// A controller that is activated or deactivated while a person has its entity.
void ExternalControl::wishBehindPerson(std::size_t entity, const Controller& controller, const Wish& wish)
{
    Attachment& slot = _yielded[entity];
    const bool isSame = slot.controller && slot.controller->name == controller.name &&
                        slot.controller->objectName == controller.objectName;
    const bool longitudinal = wish.longitudinal.value_or(isSame && slot.isLongitudinal);
    const bool lateral = wish.lateral.value_or(isSame && slot.isLateral);
    slot = longitudinal || lateral ? Attachment{nullptr, controller, longitudinal, lateral} : Attachment{};
}

std::vector<std::pair<int, int>> ExternalControl::touches() const
{
    std::vector<std::pair<int, int>> touches;
    for (std::size_t i = 0; i < _external.size(); ++i)
        if (isByPerson(i))
            for (const int other : _external[i].motion->touched())
                touches.emplace_back(static_cast<int>(i), other);
    return touches;
}

/// Who has each entity, and what was hit since the step before.
void ExternalControl::tell()
{
    for (std::size_t i = 0; i < _told.size(); ++i)
    {
        EntityTold& told = _told[i];
        told = {};
        const Attachment& attachment = _external[i];
        if (!attachment.motion) continue;
        if (attachment.controller) told.drivenBy = attachment.controller->kind();
        if (!attachment.isByPerson) continue;
        told.drivenBy = "person";
        const std::span<const Impact> impacts = attachment.motion->impacts();
        for (; _impactsTold[i] < impacts.size(); ++_impactsTold[i])
        {
            const Impact& impact = impacts[_impactsTold[i]];
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
