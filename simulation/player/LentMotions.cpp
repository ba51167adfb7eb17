// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/LentMotions.h"

#include <algorithm>
#include <cstdio>

namespace simulation
{

LentMotions::LentMotions(Place place, std::shared_ptr<MotionSource> source)
    : _place(std::move(place)),
      _source(std::move(source)),
      _lent(_place.scenario.entities.size()),
      _waiting(_place.scenario.entities.size())
{
}

void LentMotions::lend(std::size_t entity, std::shared_ptr<ExternalMotion> motion)
{
    _waiting[entity] = {std::move(motion), std::nullopt, true, true};
}

foundation::Outcome LentMotions::begin(std::size_t entity, Lent lent, double timeS)
{
    EntityMotion& own = _place.motions[entity];
    const EnvironmentState environment = _place.environment();
    if (lent.motion)
    {
        if (auto begun = lent.motion->begin(own.state(), own.isAirborne(), timeS, environment); !begun)
            return begun;
    }
    else
    {
        auto made = _source->make(*lent.controller, _place.scenario.entities[entity],
                                  {own.state(), own.isAirborne(), timeS, environment, _place.wayOf(own)});
        if (!made) return made.error();
        lent.motion = std::move(*made);
    }
    own.takeState(lent.motion->state(), timeS);
    _lent[entity] = std::move(lent);
    return foundation::success();
}

void LentMotions::wish(std::size_t entity, const Controller& controller, const Wish& wish, double timeS)
{
    Lent& slot = _hasBegun ? _lent[entity] : _waiting[entity];
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
    Lent lent{nullptr, controller, longitudinal, lateral};
    if (!_hasBegun)
    {
        slot = std::move(lent);
        return;
    }
    if (!_source) return;
    const auto begun = begin(entity, std::move(lent), timeS);
    if (begun) return;
    char time[40];
    std::snprintf(time, sizeof time, " at %.2f s: ", timeS);
    _notes.push_back(_place.scenario.entities[entity].name + ", controller " + controller.name + time +
                     begun.error().message() + "; the scenario moves it");
}

void LentMotions::release(std::size_t entity, double timeS)
{
    if (!has(entity)) return;
    if (const std::string note = _lent[entity].motion->note(); !note.empty())
        _notes.push_back(_place.scenario.entities[entity].name + " " + note);
    _lent[entity] = {};
    EntityMotion& own = _place.motions[entity];
    own.setSpeed(own.state().speedMps, timeS);
}

void LentMotions::restart(std::size_t entity, double timeS)
{
    if (!has(entity) || !_lent[entity].controller) return;
    const Lent lent = _lent[entity];
    release(entity, timeS);
    wish(entity, *lent.controller, {lent.isLongitudinal, lent.isLateral}, timeS);
}

foundation::Outcome LentMotions::beginAll()
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
    return foundation::success();
}

void LentMotions::advanceTo(double timeS, const std::function<Traffic(std::size_t)>& traffic,
                            const std::function<std::optional<glm::dvec3>(std::size_t)>& askedPlace)
{
    for (std::size_t i = 0; i < _lent.size(); ++i)
    {
        const Lent& lent = _lent[i];
        if (!lent.motion) continue;
        if (!lent.isLongitudinal) lent.motion->askForSpeed(_place.motions[i].askedSpeedAt(timeS));
        if (!lent.isLateral)
            if (const auto place = askedPlace(i)) lent.motion->askForPlace(place);
        lent.motion->advanceTo(timeS, traffic(i));
    }
    for (std::size_t i = 0; i < _lent.size(); ++i)
        if (_lent[i].motion) _place.motions[i].takeState(_lent[i].motion->state(), timeS);
}

bool LentMotions::holds(std::size_t entity, ActionDomain domain) const
{
    const Lent& lent = _lent[entity];
    if (!lent.motion) return false;
    return domain == ActionDomain::longitudinal ? lent.isLongitudinal : lent.isLateral;
}

bool LentMotions::areDone() const
{
    const auto isWhole = [](const Lent& lent) { return lent.motion && !lent.controller; };
    return std::any_of(_lent.begin(), _lent.end(), isWhole) &&
           std::all_of(_lent.begin(), _lent.end(),
                       [&](const Lent& lent) { return !isWhole(lent) || lent.motion->isDone(); });
}

std::vector<std::string> LentMotions::notes() const
{
    std::vector<std::string> notes = _notes;
    for (std::size_t i = 0; i < _lent.size(); ++i)
        if (_lent[i].motion && _lent[i].controller && !_lent[i].motion->note().empty())
            notes.push_back(_place.scenario.entities[i].name + " " + _lent[i].motion->note());
    return notes;
}

} // namespace simulation
