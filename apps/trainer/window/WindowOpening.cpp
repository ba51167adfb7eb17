// SPDX-License-Identifier: Apache-2.0
// What a window opens before its first picture: display, ride, scene, pictures over it, sound.
#include <iostream>

#include "window/OpenWindow.h"
#include "window/WindowEvents.h"
#include "window/WindowSession.h"

namespace trainer
{

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
    if (!_maker && _request.seat)
    {
        const int entity = scenario.entityIndex(_request.seat->entity);
        const bool flies = entity >= 0 && scenario.entities[static_cast<std::size_t>(entity)].isAirborne();
        _vehicle = flies ? KeyScope::flight : KeyScope::drive;
    }
    if (terrain.triangulation) terrain.triangulation->setWaits(false);
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
    _window = window->window;
    if (window->drawsOnProcessor) beginCoarse();
    _loss = std::make_unique<WindowLoss>(*_window, [this] { (void)_files.finish(recordedInputs()); });
    _watch = std::make_unique<WindowWatch>(*_window);
    _injected = std::make_unique<InjectedEvents>(_window, std::move(script), _vehicle);
    _ride.scenario = std::move(scenario);
    _ride.entity = _request.seat ? _request.seat->entity : std::string();
    if (_maker)
    {
        auto ride = _maker->make(_place);
        if (!ride) return ride.error();
        _ride = std::move(*ride);
        if (_ride.controls && _request.window.byKeys) _ride.controls->watchWishes();
        _files.setName(_ride.name);
        _request.motions[_ride.entity] = _ride.motion;
    }
    auto play = PlayScene::create(_ride.scenario, std::move(terrain), _request,
                                  simulation::FixedClock(kSeatStepsPerSecond));
    if (!play) return play.error();
    _play = std::move(*play);
    _seat = _play.seat;
    followSeat();
    for (const std::string& note : _play.notes())
        std::cout << "note: " << note << '\n';
    return openPictures();
}

/// Where a processor draws, pictures are too slow nearly everywhere unless they leave out what they may: they
/// begin so.
void WindowSession::beginCoarse()
{
    _quality.beginCoarse();
    _request.frames.quality = _quality.quality();
    _request.terrain.errorTolerancePx = _quality.tolerancePx();
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
    drawAsChosen();
    if (const simulation::DynamicVehicle* const vehicle = instrumented())
    {
        _hud = std::make_unique<Hud>(hudLayoutOf(*vehicle, _request.window.units));
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
    _buffer = WindowBuffer::begin(*_window, static_cast<int>(traits.samples));
    _pictures->readFrom(_buffer);
    drawAsChosen();
    return foundation::success();
}

void WindowSession::openSound()
{
    // Time that counts by pictures has no sound.
    if (_request.sound.isMuted || _request.window.pictureS > 0.0) return;
    _sound = std::make_unique<SceneSound>(_live->player().scenario(), _play.watched);
    _speaker = std::make_unique<Loudspeaker>();
    if (!_speaker->fault().empty()) std::cout << "note: " << _speaker->fault() << "; nothing is heard\n";
}

} // namespace trainer
