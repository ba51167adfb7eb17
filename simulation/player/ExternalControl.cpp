// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/ExternalControl.h"

#include <algorithm>
#include <cstdio>

namespace simulation
{

ExternalControl::ExternalControl(Place place, std::shared_ptr<MotionSource> source)
    : _place(std::move(place)), _source(std::move(source))
{
}

void ExternalControl::attach(std::size_t entity, std::shared_ptr<ExternalMotion> motion)
{
    at(entity).waiting = {std::move(motion), std::nullopt, true, true};
}

foundation::Outcome ExternalControl::begin(std::size_t entity, Attachment attachment, double timeS)
{
    EntityMotion& own = at(entity).motion;
    const EnvironmentState environment = _place.environment();
    if (attachment.motion)
    {
        if (auto begun = attachment.motion->begin(own.state(), own.isAirborne(), timeS, environment); !begun)
            return begun;
    }
    else
    {
        auto made = _source->make(*attachment.controller, _place.scenario.entities[entity],
                                  {own.state(), own.isAirborne(), timeS, environment, _place.wayOf(own)});
        if (!made) return made.error();
        attachment.motion = std::move(*made);
    }
    own.takeState(attachment.motion->state(), timeS);
    at(entity).vehicle = std::move(attachment);
    return foundation::success();
}

void ExternalControl::wish(std::size_t entity, const Controller& controller, const Wish& wish, double timeS)
{
    if (at(entity).isByPerson()) return wishBehindPerson(entity, controller, wish);
    Attachment& slot = _hasBegun ? at(entity).vehicle : at(entity).waiting;
    const bool isSame = slot.controller && slot.controller->name == controller.name &&
                        slot.controller->objectName == controller.objectName;
    const bool longitudinal = wish.longitudinal.value_or(isSame && slot.isLongitudinal);
    const bool lateral = wish.lateral.value_or(isSame && slot.isLateral);
    if (!longitudinal && !lateral)
    {
        if (_hasBegun)
            release(entity, timeS);
        else
            slot = {};
        return;
    }
    if (isSame)
    {
        slot.isLongitudinal = longitudinal;
        slot.isLateral = lateral;
        if (lateral && slot.motion) slot.motion->askForPlace(std::nullopt);
        return;
    }
    Attachment attachment{nullptr, controller, longitudinal, lateral};
    if (!_hasBegun)
    {
        slot = std::move(attachment);
        return;
    }
    if (!_source) return;
    const auto begun = begin(entity, std::move(attachment), timeS);
    if (begun) return;
    char time[40];
    std::snprintf(time, sizeof time, " at %.2f s: ", timeS);
    _notes.push_back(_place.scenario.entities[entity].name + ", controller " + controller.name + time +
                     begun.error().message() + "; the scenario moves it");
}

void ExternalControl::release(std::size_t entity, double timeS)
{
    Actor& actor = at(entity);
    if (!actor.isExternal()) return;
    if (actor.isByPerson())
    {
        actor.yielded = {};
        return;
    }
    if (const std::string note = actor.vehicle.motion->note(); !note.empty())
        _notes.push_back(_place.scenario.entities[entity].name + " " + note);
    actor.vehicle = {};
    actor.motion.setSpeed(actor.motion.state().speedMps, timeS);
}

void ExternalControl::restart(std::size_t entity, double timeS)
{
    Actor& actor = at(entity);
    if (actor.isByPerson())
    {
        actor.seat->leave(timeS);
        const Attachment yielded = actor.yielded;
        actor.vehicle = {};
        if (const auto seated = sitDown(entity, timeS); !seated)
        {
            actor.seat->refuse(seated.error());
            _notes.push_back(nameAt(entity, timeS) + seated.error().message() + "; the scenario has it");
        }
        actor.yielded = yielded;
        return;
    }
    if (!actor.isExternal() || !actor.vehicle.controller) return;
    const Attachment attachment = actor.vehicle;
    release(entity, timeS);
    wish(entity, *attachment.controller, {attachment.isLongitudinal, attachment.isLateral}, timeS);
}

foundation::Outcome ExternalControl::beginAll()
{
    _hasBegun = true;
    for (std::size_t i = 0; i < _place.actors.size(); ++i)
    {
        Attachment& waiting = at(i).waiting;
        if (!waiting.motion && (!waiting.controller || !_source)) continue;
        const bool isOfScenario = waiting.controller.has_value();
        const auto begun = begin(i, std::move(waiting), 0.0);
        if (begun) continue;
        foundation::Error error = begun.error();
        if (isOfScenario) error.place = _place.scenario.entities[i].name + ", " + error.place;
        return error;
    }
    for (std::size_t i = 0; i < _place.actors.size(); ++i)
    {
        if (!isAboutToSit(i, 0.0)) continue;
        if (const auto seated = sitDown(i, 0.0); !seated)
            return foundation::Error{_place.scenario.entities[i].name + ", " + seated.error().place,
                                     seated.error().what, seated.error().remedy};
    }
    tell();
    return foundation::success();
}

bool ExternalControl::areDone(double timeS) const
{
    const std::vector<Actor>& actors = _place.actors;
    const auto isWhole = [](const Actor& actor)
    { return actor.isExternal() && !actor.vehicle.controller && !actor.isByPerson(); };
    const auto isOver = [&](const Actor& actor) { return actor.seat && actor.seat->isDone(timeS); };
    if (std::any_of(actors.begin(), actors.end(), isOver)) return true;
    return std::any_of(actors.begin(), actors.end(), isWhole) &&
           std::all_of(actors.begin(), actors.end(),
                       [&](const Actor& actor) { return !isWhole(actor) || actor.vehicle.motion->isDone(); });
}

std::vector<std::string> ExternalControl::notes() const
{
    std::vector<std::string> notes = _notes;
    for (std::size_t i = 0; i < _place.actors.size(); ++i)
    {
        const Attachment& attachment = at(i).vehicle;
        if (!attachment.motion || (!attachment.controller && !attachment.isByPerson)) continue;
        if (const std::string note = attachment.motion->note(); !note.empty())
            notes.push_back(_place.scenario.entities[i].name + " " + note);
    }
    return notes;
}

} // namespace simulation
