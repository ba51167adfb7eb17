// SPDX-License-Identifier: Apache-2.0
#include "window/WindowSession.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <thread>

#include "window/DisplayLoss.h"
#include "window/EndSignals.h"
#include "window/OpenWindow.h"
#include "window/WindowEvents.h"

namespace trainer
{

namespace
{

constexpr int kSeatStepsPerSecond = 120;
constexpr double kToldS = 4.0; ///< how long a message stands
constexpr auto kLeastPicture = std::chrono::microseconds(16'000);

} // namespace

WindowSession::WindowSession(const PlayRequest& request, RideMaker* maker,
                             const std::filesystem::path& recordInputs)
    : _request(request),
      _maker(maker),
      _vehicle(maker ? maker->kind() : KeyScope::all),
      _files(request.output.motionFile, recordInputs,
             request.scenario.empty() ? "scenario" : request.scenario.filename().string()),
      _pictures(new PictureTaker(request.window.picturesFolder)),
      _begun(std::chrono::steady_clock::now()),
      _quality(request.terrain.errorTolerancePx, request.window.choosesTolerance, request.frames.quality,
               request.window.choosesQuality)
{
}

WindowSession::~WindowSession() = default;

foundation::Result<std::unique_ptr<WindowSession>>
WindowSession::create(simulation::Scenario scenario, SceneTerrain terrain, const PlayRequest& request,
                      RideMaker* maker, const std::filesystem::path& recordInputs)
{
    std::unique_ptr<WindowSession> session(new WindowSession(request, maker, recordInputs));
    if (const auto opened = session->open(std::move(scenario), std::move(terrain)); !opened)
        return opened.error();
    return session;
}

foundation::Outcome WindowSession::open(simulation::Scenario scenario, SceneTerrain terrain)
{
    if (!_request.window.keysFile.empty())
    {
        auto script = readKeyScript(_request.window.keysFile);
        if (!script) return script.error();
        _script = std::move(*script);
    }
    if (const auto opened = openDevices(); !opened) return opened;
    // Before the work of a scene, so that a machine without a display hears of it at once.
    auto window = openWindow(_request.window, _request.frames);
    if (!window) return window.error();
    _window = *window;
    _ride.scenario = std::move(scenario);
    if (_maker)
    {
        auto ride = _maker->make(_place);
        if (!ride) return ride.error();
        _ride = std::move(*ride);
        _files.setName(_ride.name);
        _request.motions[_ride.entity] = _ride.motion;
    }
    auto play = PlayScene::create(_ride.scenario, std::move(terrain), _request,
                                  simulation::FixedClock(kSeatStepsPerSecond));
    if (!play) return play.error();
    _play = std::move(*play);
    for (const std::string& note : _play.notes())
        std::cout << "note: " << note << '\n';
    return openPictures();
}

foundation::Outcome WindowSession::openPictures()
{
    _viewer = new SeatViewer([this] { afterEvents(); });
    _viewer->setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    _viewer->setKeyEventSetsDone(0);
    _viewer->setLightingMode(osg::View::NO_LIGHT);
    _viewer->setSceneData(&_play.scene->root());
    const osg::GraphicsContext::Traits& traits = *_window->getTraits();
    _rig = std::make_unique<ChannelRig>(*_viewer, singleChannel(traits.width, traits.height),
                                        std::vector<osg::ref_ptr<osg::GraphicsContext>>{_window});
    if (_ride.motion)
    {
        _hud = std::make_unique<Hud>(hudLayoutOf(_ride.motion->vehicle().vehicle(), _request.window.units));
        _hud->camera()->setGraphicsContext(_window);
        _viewer->addSlave(_hud->camera(), false);
    }
    _overlay.camera()->setGraphicsContext(_window);
    _overlay.camera()->setFinalDrawCallback(_pictures);
    _viewer->addSlave(_overlay.camera(), false);
    if (_request.frames.interior.value_or(true)) _interior = SceneInterior::create(_play, *_viewer, *_rig);
    _camera = std::make_unique<SeatCamera>(_play, _request.frames);
    _keys = std::make_unique<SeatKeys>(_vehicle, static_cast<KeyTarget&>(*this));
    _viewer->addEventHandler(new WindowEvents(*_keys, *_camera));
    _live = std::make_unique<simulation::LivePlay>(
        std::move(_play.player), [this](const simulation::ScenarioPlayer& player) { _files.add(player); });
    openSound();
    fitToWindow();
    if (_request.output.captureFolder.empty()) return foundation::success();
    auto capture = osgOffscreen::FrameCapture::begin(_window, _request.output.captureFolder);
    if (!capture) return capture.error();
    _capture = std::move(*capture);
    return foundation::success();
}

/// With the test aid each picture counts as so long, whatever it takes.
double WindowSession::wallS() const
{
    if (_request.window.pictureS > 0.0) return _times.count * _request.window.pictureS;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - _begun).count();
}

void WindowSession::playKeys(double wallS)
{
    osgGA::EventQueue& queue = *_window->getEventQueue();
    for (; _scripted < _script.size() && _script[_scripted].atS <= wallS; ++_scripted)
    {
        const WindowEvent& event = _script[_scripted];
        switch (event.kind)
        {
        case WindowEvent::Kind::press:
            queue.keyPress(event.key, queue.getTime(), event.key);
            break;
        case WindowEvent::Kind::release:
            queue.keyRelease(event.key, queue.getTime(), event.key);
            break;
        case WindowEvent::Kind::resize:
            _window->setWindowRectangle(_window->getTraits()->x, _window->getTraits()->y, event.widthPx,
                                        event.heightPx);
            break;
        case WindowEvent::Kind::close:
            queue.closeWindow();
            break;
        }
    }
}

/// The size of the window may change at any time.
void WindowSession::fitToWindow()
{
    const int width = std::max(_window->getTraits()->width, 16);
    const int height = std::max(_window->getTraits()->height, 16);
    const bool isInterior = _interior && _interior->view().isShown();
    ViewSetup setup =
        isInterior ? singleChannel(width, height, SceneInterior::kPictureDeg) : singleChannel(width, height);
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

void WindowSession::openSound()
{
    // Time that counts by pictures has no sound.
    if (_request.sound.isMuted || _request.window.pictureS > 0.0) return;
    _sound = std::make_unique<SceneSound>(_live->player().scenario(), _play.watched);
    _speaker = std::make_unique<Loudspeaker>();
    if (!_speaker->fault().empty()) std::cout << "note: " << _speaker->fault() << "; nothing is heard\n";
}

void WindowSession::sound()
{
    if (!_speaker) return;
    if (_live->pace().isPaused()) return _speaker->pause();
    _speaker->set(_sound->hear(_live->shown(), vehicleOf(_ride.motion.get())));
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
        _interior->update(_play, _live->player(), _live->shown(), _ride.motion.get(), eye, *_rig,
                          MirrorPace::one);
}

void WindowSession::afterEvents()
{
    const double wall = wallS();
    readDevicesNow();
    const bool wasOver = _live->isOver();
    _live->advance(wall);
    if (_live->isOver() && !wasOver) tell("the end; BackSpace begins again");
    _viewer->getFrameStamp()->setSimulationTime(_live->pace().timeS());
    _play.scene->show(_live->player(), _live->shown());
    look(wall);
    _lastWallS = wall;
    _overlay.showMark(_camera->isMap(), _live->shown()[_play.watched].headingDeg);
    if (_hud) _hud->show(isHudShown());
    if (_hud) _hud->setValues(hudValuesOf(_ride.motion->vehicle().vehicle(), _request.window.units));
    sound();
    showTexts(wall);
}

void WindowSession::tell(const std::string& text)
{
    _told = text;
    _toldAtS = _lastWallS;
}

void WindowSession::showTexts(double wallS)
{
    if (const auto note = _pictures->takeNote()) tell(*note);
    const simulation::RealTimePace& pace = _live->pace();
    std::string line = wallS - _toldAtS < kToldS ? _told : "";
    if (line.empty() && pace.isPaused()) line = "pause";
    if (line.empty() && pace.rate() != 1.0)
    {
        char text[40];
        std::snprintf(text, sizeof text, "%g times real time", pace.rate());
        line = text;
    }
    _overlay.setMessage(line);
    if (!_overlay.areStatisticsShown()) return;
    char text[300];
    const double meanMs = _times.count > 0 ? _times.sumMs / _times.count : 0.0;
    std::snprintf(text, sizeof text,
                  "time     %8.2f s\npicture  %8.1f ms\nmean     %8.1f ms\nworst    %8.1f ms\n"
                  "steps    %8lld\ncut      %8.2f s\nerror    %8.2f px\n%s",
                  pace.timeS(), _times.lastMs, meanMs, _times.worstMs, static_cast<long long>(pace.steps()),
                  pace.cutS(), _quality.tolerancePx(),
                  _ride.hands ? std::string(_ride.hands->phase()).c_str() : "");
    _overlay.setStatistics(text);
}

void WindowSession::waitForNext(std::chrono::steady_clock::time_point begun) const
{
    if (_request.window.pictureS > 0.0) return;
    std::this_thread::sleep_until(begun + kLeastPicture);
}

void WindowSession::measurePicture(std::chrono::steady_clock::time_point begun)
{
    _times.lastMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
    _times.sumMs += _times.lastMs;
    _times.worstMs = std::max(_times.worstMs, _times.lastMs);
    ++_times.count;
    // Time that counts by pictures gives the same ones on every machine.
    if (_request.window.pictureS > 0.0) return;
    const Quality before = _quality.quality();
    if (!_quality.add(_times.lastMs)) return;
    if (_quality.quality() != before) setQuality(_play, _quality.quality());
    setTolerance(_play.terrain, _quality.tolerancePx());
}

foundation::Outcome WindowSession::run()
{
    const DisplayLoss loss([this] { (void)_files.finish(_ride.motion.get()); });
    const EndSignals signals;
    _begun = std::chrono::steady_clock::now();
    while (!_viewer->done() && !_isEnded && !signals.haveCome() && _failed)
    {
        const auto begun = std::chrono::steady_clock::now();
        playKeys(wallS());
        _viewer->frame();
        measurePicture(begun);
        waitForNext(begun);
    }
    tellEnd();
    return finish();
}

void WindowSession::tellEnd() const
{
    const simulation::RealTimePace& pace = _live->pace();
    std::printf("shown %.2f s in %.2f s of the clock, %d pictures of %.1f ms, %.1f ms at most\n",
                pace.timeS(), pace.wallS(), _times.count,
                _times.count > 0 ? _times.sumMs / _times.count : 0.0, _times.worstMs);
    if (pace.cutS() > 0.0)
        std::printf("note: %.2f s were lost in pictures that took longer than a second\n", pace.cutS());
}

foundation::Outcome WindowSession::finish()
{
    const auto written = _files.finish(_ride.motion.get());
    if (_capture)
        if (const auto captured = _capture->finish(); !captured) return captured.error();
    return _failed ? written : _failed;
}

} // namespace trainer
