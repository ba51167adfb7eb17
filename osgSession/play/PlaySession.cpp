// SPDX-License-Identifier: Apache-2.0
#include "PlaySession.h"

#include <algorithm>
#include <chrono>
#include <fstream>

#include <foundation/WholeFile.h>
#include <unistd.h>

#include <osgOffscreen/FrameGrabber>
#include <osgOffscreen/OffscreenContext>

#include "MeasurePatches.h"
#include "measurement/ProcessorTime.h"
#include "simulation/player/StateBetween.h"
#include "view/CameraTimings.h"
#include "view/ViewFile.h"
#include "view/WatchedEntity.h"

namespace trainer
{

namespace
{

foundation::Result<ViewSetup> viewOf(const FrameRequest& frames, const simulation::ScenarioObject& ownship)
{
    if (!frames.viewFile.empty()) return readView(frames.viewFile);
    ViewSetup setup = frames.showsInterior(false)
                          ? singleChannel(frames.widthPx, frames.heightPx, SceneInterior::kPictureDeg)
                          : singleChannel(frames.widthPx, frames.heightPx);
    setup.nearM = frames.showsInterior(false) ? kNearFromInsideM : nearPlaneM(ownship, frames.eye);
    return setup;
}

/// The memory of this process that is in use, by Linux's /proc; 0 where that is not there.
double residentMb()
{
    std::ifstream file("/proc/self/statm");
    double size = 0.0, resident = 0.0;
    if (!(file >> size >> resident)) return 0.0;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-6;
}

/// One for all pictures, which one rig draws.
osgOffscreen::FrameBuffer::Sampling samplingOf(const std::vector<PictureShape>& pictures)
{
    using Sampling = osgOffscreen::FrameBuffer::Sampling;
    constexpr int kMostPx = 8192; // twice as many are the most that Mesa draws into
    const bool areSmall = std::all_of(pictures.begin(), pictures.end(),
                                      [](const PictureShape& picture)
                                      { return std::max(picture.widthPx, picture.heightPx) <= kMostPx; });
    return areSmall ? Sampling::cheapest : Sampling::multisampled;
}

osg::ref_ptr<osgViewer::Viewer> makeViewer(osg::Group& scene)
{
    const osg::ref_ptr<osgViewer::Viewer> viewer = new osgViewer::Viewer;
    viewer->setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    viewer->setKeyEventSetsDone(0);
    viewer->setLightingMode(osg::View::NO_LIGHT);
    viewer->setSceneData(&scene);
    return viewer;
}

} // namespace

PlaySession::PlaySession(const PlayRequest& request, PlayScene play)
    : _request(request), _play(std::move(play))
{
}

foundation::Result<std::unique_ptr<PlaySession>>
PlaySession::create(simulation::Scenario scenario, SceneTerrain terrain, const PlayRequest& request)
{
    // What a person and the traffic do counts the same steps at every rate of pictures.
    return create(std::move(scenario), std::move(terrain), request,
                  request.seat || request.trafficRoads
                      ? simulation::FixedClock(kSeatStepsPerSecond)
                      : simulation::FixedClock::forFrameRate(request.frames.perSecond));
}

foundation::Result<std::unique_ptr<PlaySession>> PlaySession::create(simulation::Scenario scenario,
                                                                     SceneTerrain terrain,
                                                                     const PlayRequest& request,
                                                                     const simulation::FixedClock& clock)
{
    auto play = PlayScene::create(std::move(scenario), std::move(terrain), request, clock);
    if (!play) return play.error();
    const auto setup = viewOf(request.frames, play->ownship());
    if (!setup) return setup.error();
    std::unique_ptr<PlaySession> session(new PlaySession(request, std::move(*play)));
    if (const auto opened = session->openPictures(*setup); !opened) return opened.error();
    session->beginLog();
    request.terrain.opening->end("contexts");
    if (!request.sound.file.empty())
        session->_sound = std::make_unique<SoundTrack>(request.sound, session->_play.player->scenario(),
                                                       session->_play.watched, request.frames.perSecond);
    return session;
}

void PlaySession::beginLog()
{
    if (!_request.output.motionFile.empty())
    {
        const std::string name = _request.scenario.empty() ? "scenario" : _request.scenario.string();
        _log.emplace(_request.output.motionFile, _play.player->scenario(), name,
                     !_play.player->told().empty());
        _log->add(0.0, _play.player->entities(), _play.player->told());
    }
}

/// Puts the eye where the request has it.
void PlaySession::takeSeat()
{
    _eye = std::make_unique<OwnshipEye>(_play.ownship(), trainOf(_play.player->scenario(), _play.watched),
                                        _play.scene->eyeIn(_play.watched), _request.frames,
                                        _play.terrain.ground());
    _play.setEye(_request.frames.eye);
    if (_request.frames.isInside()) _play.scene->hide(_play.watched);
}

foundation::Outcome PlaySession::setEye(EyePoint eye, const std::string& entity, const FreeEye& free)
{
    const auto watched = watchedEntity(_play.player->scenario(), entity);
    if (!watched) return watched.error();
    if (_request.frames.isInside()) _play.scene->hide(_play.watched, false);
    _play.watched = *watched;
    _play.scene->bearLamps(_play.watched);
    _request.frames.eye = eye;
    _request.frames.freeEye = free;
    takeSeat();
    ViewSetup setup = _rig->setup();
    setup.nearM = nearPlaneM(_play.ownship(), eye);
    _rig->reshape(std::move(setup));
    return foundation::success();
}

foundation::Outcome PlaySession::openPictures(const ViewSetup& setup)
{
    takeSeat();
    const std::vector<PictureShape> pictures = picturesOf(setup);
    const auto sampling = samplingOf(pictures);
    for (const PictureShape& picture : pictures)
    {
        const auto context = osgOffscreen::OffscreenContext::create(
            {_request.frames.backend, picture.widthPx, picture.heightPx, _request.frames.samples,
             osgOffscreen::kEverythingNeeds, sampling});
        if (!context) return context.error();
        _drawnSide = (*context)->drawnSide(); // of one driver
        _contexts.push_back(*context);
    }
    _viewer = makeViewer(_play.scene->root());
    _rig = std::make_unique<ChannelRig>(*_viewer, setup, _contexts);
    drawWith(_play, *_rig, _request.frames.quality, _request.terrain.errorTolerancePx, _drawnSide);
    if (_request.frames.showsInterior(false)) _interior = SceneInterior::create(_play, *_viewer, *_rig);
    keepCameraTimings(*_viewer);
    // Patches and samples between those of the raster, as roads have them, exclude each other.
    if (!_request.terrain.patchExponent && _play.terrain.terrain && !_play.terrain.roads) tunePatches();
    if (!_request.output.partsFile.empty())
        _parts = std::make_unique<PictureParts>(_play, _interior ? &_interior->view() : nullptr, *_viewer,
                                                _contexts);
    return beginCaptures(setup);
}

foundation::Outcome PlaySession::beginCaptures(const ViewSetup& setup)
{
    if (_request.output.captureFolder.empty()) return foundation::success();
    const std::vector<PictureShape> pictures = picturesOf(setup);
    for (std::size_t i = 0; i < pictures.size(); ++i)
    {
        const auto folder = pictures.size() == 1 ? _request.output.captureFolder
                                                 : _request.output.captureFolder / pictures[i].name;
        auto capture = osgOffscreen::FrameCapture::begin(_contexts[i], folder);
        if (!capture) return capture.error();
        _captures.push_back(std::move(*capture));
    }
    return foundation::success();
}

/// Measures patch exponents at time 0 while the camera moves ahead at the initial speed of the ownship.
void PlaySession::tunePatches()
{
    constexpr double kLeastStepM = 0.5;
    _play.scene->show(*_play.player);
    const simulation::EntityState& ownship = _play.player->entities()[_play.watched];
    scenery::Pose eye = _eye->update(ownship, 0.0);
    const double stepM = std::max(kLeastStepM, ownship.speedMps / _request.frames.perSecond);
    _patchNote = measurePatches(*_play.terrain.terrain, *_viewer, _contexts,
                                [&]
                                {
                                    eye.positionWorld += stepM * eye.forward();
                                    _rig->setEye(eye);
                                });
}

std::vector<std::string> PlaySession::notes() const
{
    std::vector<std::string> notes = _play.notes();
    if (!_patchNote.empty()) notes.push_back(_patchNote);
    return notes;
}

/// Null: the player moves it.
const simulation::ExternalMotion* PlaySession::motionOfOwnship() const
{
    if (_play.seat && _play.seat->entity() == _play.ownship().name) return _play.seat->motion().get();
    const auto moved = _request.motions.find(_play.ownship().name);
    return moved == _request.motions.end() ? nullptr : moved->second.get();
}

/// Moves the eye, and the inside of the vehicle with it. `dtS`: since the last picture.
void PlaySession::look(double dtS)
{
    const auto& entities = shown();
    scenery::Pose eye = _eye->update(entities[_play.watched], dtS);
    if (_interior) eye = bent(eye, -_interior->view().lookDownDeg());
    _rig->setEye(eye);
    _play.follow(eye.positionWorld);
    if (!_interior) return;
    _interior->update(_play, *_play.player, entities, motionOfOwnship(), {eye, *_rig, MirrorPace::all});
}

const std::vector<simulation::EntityState>& PlaySession::shown() const
{
    return _between.empty() ? _play.player->entities() : _between;
}

void PlaySession::draw(double dtS)
{
    _play.scene->show(*_play.player, shown());
    const auto begin = std::chrono::steady_clock::now();
    const double usedMs = measurement::processorMs();
    look(_statistics.empty() ? 0.0 : dtS);
    if (_parts)
        _parts->draw(_play.player->timeS());
    else
        _viewer->frame(_play.player->timeS());
    const auto end = std::chrono::steady_clock::now();
    _statistics.push_back(measured());
    _statistics.back().processorMs = measurement::processorMs() - usedMs;
    if (_statistics.size() == 1) _request.terrain.opening->end("first picture");
    _statistics.back().wallMs = std::chrono::duration<double, std::milli>(end - begin).count();
}

osg::ref_ptr<osg::Image> PlaySession::picture(double dtS)
{
    osg::ref_ptr<osg::Image> picture;
    osg::GraphicsContext& context = *_contexts.front();
    const osg::ref_ptr<osgOffscreen::FrameGrabber> grabber = new osgOffscreen::FrameGrabber(
        [&picture](const osgOffscreen::GrabbedFrame& frame) { picture = frame.picture; }, 0);
    const osg::ref_ptr<osg::GraphicsContext::SwapCallback> before = context.getSwapCallback();
    context.setSwapCallback(grabber);
    draw(dtS);
    context.setSwapCallback(before);
    grabber->drain(&context);
    return picture;
}

/// Makes the steps up to the next picture, and the one that it lies in: then it shows the states between.
void PlaySession::advance()
{
    const std::int64_t perSecond = _request.frames.perSecond;
    const std::int64_t scaled = ++_frames * _play.player->clock().stepsPerSecond();
    const std::int64_t due = (scaled + perSecond - 1) / perSecond;
    std::vector<simulation::EntityState> before;
    // Recorded inputs end at their step, not at that of a picture.
    for (; _steps < due && !(_request.seat && isFinished()); ++_steps)
    {
        if (scaled % perSecond != 0) before = _play.player->entities();
        _play.player->step();
        if (_log) _log->add(_play.player->timeS(), _play.player->entities(), _play.player->told());
    }
    _between.clear();
    if (before.empty()) return;
    const double share = 1.0 - static_cast<double>(due * perSecond - scaled) / static_cast<double>(perSecond);
    const std::vector<simulation::EntityState>& now = _play.player->entities();
    for (std::size_t i = 0; i < now.size(); ++i)
        _between.push_back(simulation::stateBetween(before[i], now[i], share, _play.player->clock().stepS()));
}

foundation::Outcome PlaySession::frame()
{
    draw(1.0 / _request.frames.perSecond);
    advance();
    if (_sound)
        if (const auto heard = _sound->add(_play.player->entities(), motionOfOwnship()); !heard) return heard;
    for (const auto& capture : _captures)
        if (const auto outcome = capture->outcome(); !outcome) return outcome.error();
    return foundation::success();
}

FrameStatistics PlaySession::measured()
{
    FrameStatistics row;
    row.frame = static_cast<std::uint32_t>(_statistics.size());
    row.timeS = _play.player->timeS();
    const unsigned drawn = _viewer->getFrameStamp()->getFrameNumber();
    const CameraTimings timings = cameraTimings(*_viewer, drawn);
    row.cullMs = timings.cullMs;
    row.drawMs = timings.drawMs;
    if (_play.scenery) row.objects = _play.scenery->figures(drawn);
    row.residentMb = residentMb();
    if (!_play.terrain.terrain) return row;
    std::uint64_t uploadedBytes = 0;
    for (const auto& group : _play.terrain.terrain->statistics())
    {
        uploadedBytes += group.bytesUploaded;
        if (group.frame != drawn) continue; // an eye that has gone
        row.triangles += group.refine.triangles;
        row.splits += group.refine.splits;
        row.merges += group.refine.merges;
        row.adaptUs += group.adaptUs;
        row.maxErrorPx = std::max({row.maxErrorPx, group.refine.tolerancePx, group.refine.errorBoundPx});
    }
    if (_play.terrain.triangulation)
        for (const auto& group : _play.terrain.triangulation->statistics())
        {
            if (group.frame != drawn) continue;
            row.triangles += group.triangles;
            row.adaptUs += group.stallUs;
            row.maxErrorPx = _play.terrain.terrain->settings().errorTolerancePx;
        }
    row.maxErrorPx /= _drawnSide; // of the picture's
    // A group that has gone takes its count with it.
    row.uploadBytes = uploadedBytes - std::min(uploadedBytes, _uploadedBytes);
    _uploadedBytes = uploadedBytes;
    return row;
}

foundation::Outcome PlaySession::finish()
{
    for (const auto& capture : _captures)
        if (const auto written = capture->finish(); !written) return written.error();
    if (_sound)
        if (const auto written = _sound->finish(); !written) return written;
    if (_request.seat && !_request.seat->recordInputs.empty())
        if (const auto written = foundation::writeWholeFile(
                _request.seat->recordInputs,
                simulation::writeInputs(_play.seat->recorded(_play.player->timeS())));
            !written)
            return written;
    return _log ? _log->finish() : foundation::success();
}

} // namespace trainer
