// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/ExternalControl.h"

#include <algorithm>
#include <cstdio>

namespace simulation
{

ExternalControl::ExternalControl(Place place, std::shared_ptr<MotionSource> source)
    : _place(std::move(place)),
      _source(std::move(source)),
      _external(_place.scenario.entities.size()),
      _waiting(_place.scenario.entities.size()),
      _seats(_place.scenario.entities.size()),
      _yielded(_place.scenario.entities.size()),
      _askedMps(_place.scenario.entities.size(), 0.0),
      _impactsTold(_place.scenario.entities.size(), 0)
{
}

void ExternalControl::attach(std::size_t entity, std::shared_ptr<ExternalMotion> motion)
{
    _waiting[entity] = {std::move(motion), std::nullopt, true, true};
}

foundation::Outcome ExternalControl::begin(std::size_t entity, Attachment attachment, double timeS)
{
    EntityMotion& own = _place.motions[entity];
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
    _external[entity] = std::move(attachment);
    return foundation::success();
}

void ExternalControl::wish(std::size_t entity, const Controller& controller, const Wish& wish, double timeS)
{
    if (isByPerson(entity)) return wishBehindPerson(entity, controller, wish);
    Attachment& slot = _hasBegun ? _external[entity] : _waiting[entity];
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
    if (!has(entity)) return;
    if (isByPerson(entity))
    {
        _yielded[entity] = {};
        return;
    }
    if (const std::string note = _external[entity].motion->note(); !note.empty())
        _notes.push_back(_place.scenario.entities[entity].name + " " + note);
    _external[entity] = {};
    EntityMotion& own = _place.motions[entity];
    own.setSpeed(own.state().speedMps, timeS);
}

void ExternalControl::restart(std::size_t entity, double timeS)
{
    if (isByPerson(entity))
    {
        _seats[entity]->leave(timeS);
        const Attachment yielded = _yielded[entity];
        _external[entity] = {};
        if (const auto seated = sitDown(entity, timeS); !seated)
        {
            _seats[entity]->refuse(seated.error());
            _notes.push_back(nameAt(entity, timeS) + seated.error().message() + "; the scenario has it");
        }
        _yielded[entity] = yielded;
        return;
    }
    if (!has(entity) || !_external[entity].controller) return;
    const Attachment attachment = _external[entity];
    release(entity, timeS);
    wish(entity, *attachment.controller, {attachment.isLongitudinal, attachment.isLateral}, timeS);
}

foundation::Outcome ExternalControl::beginAll()
{
    _hasBegun = true;
    for (std::size_t i = 0; i < _waiting.size(); ++i)
    {
        if (!_waiting[i].motion && (!_waiting[i].controller || !_source)) continue;
        const bool isOfScenario = _waiting[i].controller.has_value();
        const auto begun = begin(i, std::move(_waiting[i]), 0.0);
        if (begun) continue;
        foundation::Error error = begun.error();
        if (isOfScenario) error.place = _place.scenario.entities[i].name + ", " + error.place;
        return error;
    }
    for (std::size_t i = 0; i < _seats.size(); ++i)
    {
        if (!isAboutToSit(i, 0.0)) continue;
        if (const auto seated = sitDown(i, 0.0); !seated)
            return foundation::Error{_place.scenario.entities[i].name + ", " + seated.error().place,
                                     seated.error().what, seated.error().remedy};
    }
    tell();
    return foundation::success();
}

void ExternalControl::advanceTo(double timeS, const std::function<Traffic(std::size_t)>& traffic,
                                const std::function<std::optional<glm::dvec3>(std::size_t)>& askedPlace)
{
    for (std::size_t i = 0; i < _external.size(); ++i)
    {
        const Attachment& attachment = _external[i];
        if (!attachment.motion) continue;
        if (!attachment.isLongitudinal) attachment.motion->askForSpeed(_place.motions[i].askedSpeedAt(timeS));
        if (!attachment.isLateral)
            if (const auto place = askedPlace(i)) attachment.motion->askForPlace(place);
        attachment.motion->advanceTo(timeS, traffic(i));
    }
    for (std::size_t i = 0; i < _external.size(); ++i)
        if (_external[i].motion) _place.motions[i].takeState(_external[i].motion->state(), timeS);
    tell();
}

bool ExternalControl::holds(std::size_t entity, ActionDomain domain) const
{
    const Attachment& attachment = _external[entity];
    if (!attachment.motion) return false;
    return domain == ActionDomain::longitudinal ? attachment.isLongitudinal : attachment.isLateral;
}

bool ExternalControl::areDone(double timeS) const
{
    const auto isWhole = [](const Attachment& attachment)
    { return attachment.motion && !attachment.controller && !attachment.isByPerson; };
    const auto isOver = [&](const std::shared_ptr<Seat>& seat) { return seat && seat->isDone(timeS); };
    if (std::any_of(_seats.begin(), _seats.end(), isOver)) return true;
    return std::any_of(_external.begin(), _external.end(), isWhole) &&
           std::all_of(_external.begin(), _external.end(),
                       [&](const Attachment& attachment)
                       { return !isWhole(attachment) || attachment.motion->isDone(); });
}

std::vector<std::string> ExternalControl::notes() const
{
    std::vector<std::string> notes = _notes;
    for (std::size_t i = 0; i < _external.size(); ++i)
    {
        const Attachment& attachment = _external[i];
        if (!attachment.motion || (!attachment.controller && !attachment.isByPerson)) continue;
        if (const std::string note = attachment.motion->note(); !note.empty())
            notes.push_back(_place.scenario.entities[i].name + " " + note);
    }
    return notes;
}

} // namespace simulation
