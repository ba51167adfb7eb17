// SPDX-License-Identifier: Apache-2.0
#include "window/WindowSession.h"

#include <algorithm>
#include <thread>

#include "measurement/ProcessorTime.h"
#include "window/EndSignals.h"

namespace trainer
{

namespace
{

constexpr auto kLeastPicture = std::chrono::microseconds(16'000);

} // namespace

/// With the test aid each picture counts as so long, whatever it takes.
double WindowSession::wallS() const
{
    if (_request.window.pictureS > 0.0) return _times.count() * _request.window.pictureS;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - _begun).count();
}

void WindowSession::injectEvents(double wallS)
{
    _injected->playScript(wallS);
    if (!_request.window.byKeys || !_ride.controls || _seat) return;
    const double nextS = _request.window.pictureS > 0.0 ? _request.window.pictureS : 1e-3 * _times.lastMs();
    _injected->moveHand(*_ride.controls, _ride.motion->vehicle().vehicle(), nextS);
}

/// The size of the window may change at any time.
void WindowSession::fitToWindow()
{
    if (_buffer) _buffer->fit();
    const int width = std::max(_window->getTraits()->width, 16);
    const int height = std::max(_window->getTraits()->height, 16);
    const bool isInterior = _interior && _interior->view().isShown();
    ViewSetup setup = singleChannel(width, height, _camera->pictureDeg(isInterior));
    setup.nearM = _camera->nearM();
    const Channel& before = _rig->setup().channels.front();
    const osg::Viewport* const overlay = _overlay.camera()->getViewport();
    const bool isOverlayRight = overlay && overlay->width() == width && overlay->height() == height;
    if (before.widthPx == width && before.heightPx == height && isOverlayRight &&
        before.frustum.topDeg == setup.channels.front().frustum.topDeg && _rig->setup().nearM == setup.nearM)
        return;
    _rig->reshape(setup);
    _overlay.resize(width, height);
    if (_hud) _hud->resize(width, height);
}

void WindowSession::sound()
{
    if (!_speaker) return;
    if (_live->pace().isPaused()) return _speaker->pause();
    _speaker->set(_sound->hear(_live->shown(), vehicleOf(motionOfOwnship())));
}

/// Moves the eye, and the inside of the vehicle with it.
void WindowSession::look(double wallS)
{
    if (_interior)
    {
        _interior->view().show(_camera->isInside());
        _camera->bend(-_interior->view().lookDownDeg());
    }
    fitToWindow();
    const scenery::Pose eye =
        _camera->update(_live->shown()[_play.watched], std::max(0.0, wallS - _lastWallS));
    _rig->setEye(eye);
    _play.follow(eye.positionWorld);
    if (_interior)
        _interior->update(_play, _live->player(), _live->shown(), motionOfOwnship(),
                          {eye, *_rig, _request.window.pictureS > 0.0 ? MirrorPace::all : MirrorPace::one});
}

void WindowSession::afterEvents()
{
    const double wall = wallS();
    readDevicesNow();
    const bool wasOver = _live->isOver();
    _live->advance(wall);
    followSeat();
    if (_live->isOver() && !wasOver) tell("the end; BackSpace begins again");
    tellImpacts();
    _viewer->getFrameStamp()->setSimulationTime(_live->pace().timeS());
    _play.scene->show(_live->player(), _live->shown());
    look(wall);
    _lastWallS = wall;
    _overlay.showMark(_camera->isMap(), _live->shown()[_play.watched].headingDeg);
    if (_hud) _hud->show(isHudShown() && _ride.motion);
    if (_hud && _ride.motion)
        _hud->setValues(hudValuesOf(_ride.motion->vehicle().vehicle(), _request.window.units));
    sound();
    showTexts(wall);
}

/// What was hit since the picture before; a vehicle that is no longer sound begins again by a key alone.
void WindowSession::tellImpacts()
{
    if (!_ride.motion) return _texts.setStanding({});
    const simulation::DynamicVehicle& vehicle = _ride.motion->vehicle().vehicle();
    const bool isSound = vehicle.status().condition == simulation::VehicleCondition::sound;
    const std::span<const simulation::Impact> impacts = vehicle.impacts();
    if (impacts.size() > _impactsTold) tell(simulation::textOf(impacts.back()));
    _impactsTold = impacts.size();
    _texts.setStanding(isSound ? std::string()
                               : std::string(vehicle.status().reason) + "; BackSpace begins again");
}

void WindowSession::tell(const std::string& text)
{
    _texts.tell(text, _lastWallS);
}

void WindowSession::showTexts(double wallS)
{
    if (const auto note = _pictures->takeNote()) tell(*note);
    _texts.show(_overlay, wallS, _live->pace(), _times, _quality.tolerancePx(),
                _ride.controls ? _ride.controls->phase() : std::string_view());
}

void WindowSession::waitForNext(std::chrono::steady_clock::time_point begun) const
{
    if (_request.window.pictureS > 0.0) return;
    std::this_thread::sleep_until(begun + kLeastPicture);
}

void WindowSession::measurePicture(std::chrono::steady_clock::time_point begun, double usedMs)
{
    _times.add(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count(),
               measurement::processorMs() - usedMs);
    // Time that counts by pictures gives the same ones on every machine.
    if (_request.window.pictureS > 0.0 || _isHidden) return;
    if (_quality.add(_times.lastMs())) drawAsChosen();
}

/// Draws by the quality and with the tolerance that are chosen.
void WindowSession::drawAsChosen()
{
    drawWith(_play, *_rig, _quality.quality(), _quality.tolerancePx(),
             _buffer ? _buffer->buffer().drawnSide() : 1);
}

/// Time goes on where nobody sees the window, but nothing is drawn. Keys that are held where another window
/// gets the keyboard count as let go.
void WindowSession::showPicture()
{
    const WindowWatch::State state = _watch->look();
    if (state.hasLostFocus) _keys->releaseAll();
    _isHidden = state.isHidden && _times.count() > 0;
    if (state.isGone) WindowLoss::endWithoutWindow();
    if (_isEnded) return;
    if (!_isHidden) return _viewer->frame();
    _viewer->advance();
    _viewer->eventTraversal();
}

foundation::Outcome WindowSession::run()
{
    const EndSignals signals;
    _begun = std::chrono::steady_clock::now();
    while (!_viewer->done() && !_isEnded && !signals.haveCome() && _failed)
    {
        const auto begun = std::chrono::steady_clock::now();
        const double usedMs = measurement::processorMs();
        injectEvents(wallS());
        showPicture();
        measurePicture(begun, usedMs);
        waitForNext(begun);
    }
    printEnd(_live->pace(), _times);
    return finish();
}

/// Needs a window that is open.
void WindowSession::finishCapture()
{
    if (!_capture) return;
    if (_buffer) _buffer->release();
    _pictures->readFrom(_buffer = nullptr);
    drawAsChosen();
    if (const auto captured = _capture->finish(); !captured && _failed) _failed = captured.error();
    _capture.reset();
}

foundation::Outcome WindowSession::finish()
{
    const auto written = _files.finish(recordedInputs());
    tellSeat();
    finishCapture();
    return _failed ? written : _failed;
}

} // namespace trainer
