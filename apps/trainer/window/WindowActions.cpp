// SPDX-License-Identifier: Apache-2.0
// What the keys of a window do.
#include <cmath>
#include <cstdio>

#include <foundation/DataFile.h>

#include "input/KeyInputs.h"
#include "window/WindowSession.h"

namespace trainer
{

namespace
{

constexpr double kLeanMps = 0.3;

} // namespace

/// The usual devices file need not be there: then joysticks do nothing.
foundation::Outcome WindowSession::openDevices()
{
    std::filesystem::path file = _request.window.devicesFile;
    std::error_code ignored;
    if (file.empty() && !std::filesystem::exists(file = foundation::dataFile("devices.txt"), ignored))
        return foundation::success();
    auto maps = readDevices(file);
    if (!maps) return maps.error();
    _devices = std::make_unique<Devices>();
    _deviceInputs = std::make_unique<DeviceInputs>(std::move(*maps));
    return foundation::success();
}

void WindowSession::readDevicesNow()
{
    if (!_devices) return;
    for (const std::string& note : _devices->update())
        tell(note);
    _deviceInputs->apply(_devices->states(), _ride.controls ? &_ride.controls->manual() : nullptr, *_keys);
}

void WindowSession::holdInput(std::string_view input, double direction)
{
    if (_ride.controls) trainer::holdInput(_ride.controls->manual(), input, direction);
}

void WindowSession::addToInput(std::string_view input, double amount)
{
    if (_ride.controls) trainer::addToInput(_ride.controls->manual(), input, amount);
}

void WindowSession::flipInput(std::string_view input)
{
    if (_ride.controls) trainer::flipInput(_ride.controls->manual(), input);
}

void WindowSession::handOver()
{
    if (_seat) return handOverSeat();
    if (!_ride.controls) return;
    const bool isByHand = !_ride.controls->isByHand();
    if (!_ride.controls->giveToPerson(isByHand)) return tell("there is nobody to give it to");
    if (isByHand && _live->pace().isPaused()) _live->pace().setPaused(false);
    tell(isByHand ? "you have it" : "you have given it back");
}

/// Everything from the start, or from another one; what was recorded so far is kept.
void WindowSession::restart(std::size_t place)
{
    Ride next;
    next.scenario = _ride.scenario;
    PlayRequest request = _request;
    if (_maker)
    {
        auto made = _maker->make(place);
        if (!made) return tell(made.error().message());
        next = std::move(*made);
        request.motions[next.entity] = next.motion;
    }
    const auto options =
        playerOptionsOf(next.scenario, _play.terrain, request, _live->player().clock().anew());
    if (!options) return tell(options.error().message());
    auto player = simulation::ScenarioPlayer::create(next.scenario, *options);
    if (!player) return tell(player.error().message());
    if (const auto kept = _files.next(recordedInputs()); !kept)
    {
        _failed = kept;
        return;
    }
    _keys->releaseAll();
    _live->restart(std::move(*player));
    _ride = std::move(next);
    _seat = seatOf(*options);
    if (_seat) _ride.entity = _seat->entity();
    followSeat();
    if (_ride.controls && _request.window.byKeys) _ride.controls->watchWishes();
    _request = std::move(request);
    _place = place;
    _camera->restart();
    if (!_maker) return tell("from the start");
    const RidePlace where = _maker->places()[place];
    tell(where.name);
    if (_files.recordsInputs() && !where.option.empty())
        std::printf("note: what is recorded from here is played with %s\n", where.option.c_str());
}

void WindowSession::toggleFullscreen()
{
    auto* const system = osg::GraphicsContext::getWindowingSystemInterface();
    unsigned width = 0, height = 0;
    if (system) system->getScreenResolution(*_window->getTraits(), width, height);
    if (width == 0 || height == 0) return;
    _isCovering = !_isCovering;
    if (_isCovering)
    {
        _window->getWindowRectangle(_oldPlace[0], _oldPlace[1], _oldPlace[2], _oldPlace[3]);
        _window->setWindowDecoration(false);
        _window->setWindowRectangle(0, 0, static_cast<int>(width), static_cast<int>(height));
        return;
    }
    _window->setWindowDecoration(true);
    _window->setWindowRectangle(_oldPlace[0], _oldPlace[1], _oldPlace[2], _oldPlace[3]);
}

/// Somebody who sees the instruments of a cockpit has them there, unless a key says otherwise.
bool WindowSession::isHudShown() const
{
    return _isHudWanted.value_or(!_interior || !_camera->isInside());
}

void WindowSession::act(KeyAction action, double amount)
{
    simulation::RealTimePace& pace = _live->pace();
    switch (action)
    {
    case KeyAction::help:
        return _overlay.showHelp(_vehicle, !_overlay.isHelpShown());
    case KeyAction::statistics:
        return _overlay.showStatistics(!_overlay.areStatisticsShown());
    case KeyAction::instruments:
        _isHudWanted = !isHudShown();
        return;
    case KeyAction::fullscreen:
        return toggleFullscreen();
    case KeyAction::picture:
        return _pictures->ask();
    case KeyAction::end:
        _isEnded = true;
        return;
    case KeyAction::view:
        return _camera->setView(static_cast<std::size_t>(amount));
    case KeyAction::nextView:
        return _camera->nextView();
    case KeyAction::glance:
        return _camera->glance(amount);
    case KeyAction::leanAhead:
        return _camera->lean(0, kLeanMps * amount);
    case KeyAction::leanLeft:
        return _camera->lean(1, kLeanMps * amount);
    case KeyAction::leanUp:
        return _camera->lean(2, kLeanMps * amount);
    case KeyAction::zoom:
        return _camera->zoom(std::exp2(amount));
    case KeyAction::straighten:
        return _camera->straighten();
    case KeyAction::panel:
        if (_interior) _camera->readPanel(!_camera->readsPanel(), _interior->view().panel());
        return;
    case KeyAction::altimeter:
        if (!_interior) return;
        return tell("altimeter set to " + std::to_string(std::lround(_interior->turnAltimeter(amount))) +
                    " hPa");
    case KeyAction::pause:
        return pace.setPaused(!pace.isPaused());
    case KeyAction::step:
        return pace.stepOnce();
    case KeyAction::slower:
        return pace.slower();
    case KeyAction::faster:
        return pace.faster();
    case KeyAction::realTime:
        return pace.setRate(1.0);
    case KeyAction::reset:
        return restart(_place);
    case KeyAction::reposition:
        return restart(_maker ? (_place + 1) % _maker->places().size() : 0);
    case KeyAction::handOver:
        return handOver();
    default:
        return;
    }
}

} // namespace trainer
