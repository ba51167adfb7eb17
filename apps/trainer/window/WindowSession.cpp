// SPDX-License-Identifier: Apache-2.0
#include "window/WindowSession.h"

#include <algorithm>
#include <iostream>
#include <thread>

#include "view/ProcessorTime.h"
#include "window/EndSignals.h"
#include "window/OpenWindow.h"
#include "window/WindowEvents.h"

namespace trainer
{

namespace
{

constexpr int kSeatStepsPerSecond = 120;
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
    std::vector<WindowEvent> script;
    if (!_request.window.keysFile.empty())
    {
        auto read = readKeyScript(_request.window.keysFile);
        if (!read) return read.error();
        script = std::move(*read);
    }
    if (const auto opened = openDevices(); !opened) return opened;
    // Before the work of a scene, so that a machine without a display hears of it at once.
    auto window = openWindow(_request.window, _request.frames);
    if (!window) return window.error();
    _window = *window;
    _loss = std::make_unique<WindowLoss>(*_window, [this] { (void)_files.finish(_ride.motion.get()); });
    _watch = std::make_unique<WindowWatch>(*_window);
    _injected = std::make_unique<InjectedEvents>(_window, std::move(script), _vehicle);
    _ride.scenario = std::move(scenario);
    if (_maker)
    {
        auto ride = _maker->make(_place);
        if (!ride) return ride.error();
        _ride = std::move(*ride);
        if (_ride.hands && _request.window.byKeys) _ride.hands->watchWishes();
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
    _viewer = new SeatViewer([this] { afterEvents(); }, [this] { finishCapture(); });
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
    if (_request.window.pictureS > 0.0) return _times.count() * _request.window.pictureS;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - _begun).count();
}

void WindowSession::injectEvents(double wallS)
{
    _injected->playScript(wallS);
    if (!_request.window.byKeys || !_ride.hands) return;
    const double nextS = _request.window.pictureS > 0.0 ? _request.window.pictureS : 1e-3 * _times.lastMs();
    _injected->moveHand(*_ride.hands, _ride.motion->vehicle().vehicle(), nextS);
}

/// The size of the window may change at any time.
void WindowSession::fitToWindow()
{
    const int width = std::max(_window->getTraits()->width, 16);
    const int height = std::max(_window->getTraits()->height, 16);
    const bool isInterior = _interior && _interior->view().isShown();
    ViewSetup setup =
        isInterior ? singleChannel(width, height, _camera->insideDeg()) : singleChannel(width, height);
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
                          _request.window.pictureS > 0.0 ? MirrorPace::all : MirrorPace::one);
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
    _texts.tell(text, _lastWallS);
}

void WindowSession::showTexts(double wallS)
{
    if (const auto note = _pictures->takeNote()) tell(*note);
    _texts.show(_overlay, wallS, _live->pace(), _times, _quality.tolerancePx(),
                _ride.hands ? _ride.hands->phase() : std::string_view());
}

void WindowSession::waitForNext(std::chrono::steady_clock::time_point begun) const
{
    if (_request.window.pictureS > 0.0) return;
    std::this_thread::sleep_until(begun + kLeastPicture);
}

void WindowSession::measurePicture(std::chrono::steady_clock::time_point begun, double usedMs)
{
    _times.add(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count(),
               processorMs() - usedMs);
    // Time that counts by pictures gives the same ones on every machine.
    if (_request.window.pictureS > 0.0 || _isHidden) return;
    const Quality before = _quality.quality();
    if (!_quality.add(_times.lastMs())) return;
    if (_quality.quality() != before) setQuality(_play, _quality.quality());
    setTolerance(_play.terrain, _quality.tolerancePx());
}

/// Time goes on where nobody sees the window, but nothing is drawn. Keys that are held where another window gets the keyboard count as let go.
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
        const double usedMs = processorMs();
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
    if (const auto captured = _capture->finish(); !captured && _failed) _failed = captured.error();
    _capture.reset();
}

foundation::Outcome WindowSession::finish()
{
    const auto written = _files.finish(_ride.motion.get());
    finishCapture();
    return _failed ? written : _failed;
}

} // namespace trainer
