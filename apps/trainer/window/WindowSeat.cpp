// SPDX-License-Identifier: Apache-2.0
// A person in an entity of a scenario: who has it, and what is told of that.
#include <cstdio>

#include "window/WindowSession.h"

namespace trainer
{

/// The vehicle in hand comes and goes with whoever has the entity.
void WindowSession::followSeat()
{
    if (!_seat) return;
    if (_ride.motion != _seat->motion())
    {
        _ride.motion = _seat->motion();
        _ride.controls = _seat->controls();
        _impactsTold = 0;
        if (!_ride.motion && _keys) _keys->releaseAll();
        _hasSat = true;
    }
    tellRefusal();
    if (!_hasSat) return; // a play that is only looked at has the pictures of one without a window
    const std::string& entity = _seat->entity();
    const bool isRecorded = _ride.controls && !_ride.controls->isByHand();
    _texts.setOwner(!_ride.motion ? entity + ": the scenario has it; Tab takes over"
                    : isRecorded  ? entity + ": recorded inputs have it; Tab takes over"
                                  : entity + ": you have it; Tab gives it back");
}

void WindowSession::tellRefusal()
{
    if (_seat->refusal() == _refusalTold) return;
    _refusalTold = _seat->refusal();
    if (!_refusalTold.empty()) tell("nobody can take over here: " + _refusalTold);
}

void WindowSession::handOverSeat()
{
    const bool isByHand = !_seat->isByHand();
    if (const std::string lacks = _seat->giveToPerson(isByHand); !lacks.empty()) return tell(lacks);
    if (isByHand && _live->pace().isPaused()) _live->pace().setPaused(false);
    tell(isByHand ? "you have it" : "you have given it back");
}

/// What happened to whoever sat there, on the terminal.
void WindowSession::tellSeat()
{
    if (!_seat || !_live) return;
    for (const std::string& note : _live->player().notes())
        std::printf("note: %s\n", note.c_str());
}

std::optional<simulation::InputTrack> WindowSession::recordedInputs() const
{
    if (_seat && _live) return _seat->recorded(_live->player().timeS());
    const auto* const recorder = _ride.motion ? _ride.motion->vehicle().recorder() : nullptr;
    return recorder ? std::optional(recorder->track()) : std::nullopt;
}

/// Null: the scenario moves the entity that is watched.
const simulation::VehicleMotion* WindowSession::motionOfOwnship() const
{
    const bool isOther = _seat && _seat->entity() != _live->player().scenario().entities[_play.watched].name;
    return isOther ? nullptr : _ride.motion.get();
}

/// The vehicle whose gauges the picture has; null: none.
const simulation::DynamicVehicle* WindowSession::instrumented() const
{
    if (_seat) return &_seat->model();
    return _ride.motion ? &_ride.motion->vehicle().vehicle() : nullptr;
}

} // namespace trainer
