// SPDX-License-Identifier: Apache-2.0
#include "PlaySession.h"

#include <algorithm>
#include <chrono>
#include <fstream>

#include <unistd.h>

#include <osgOffscreen/OffscreenContext>

#include "MeasurePatches.h"
#include "SceneRoads.h"
#include "simulation/road/ScenarioRoads.h"
#include "view/CameraTimings.h"
#include "view/ViewFile.h"

namespace trainer
{

namespace
{

/// Returns the near plane of a view that sets none, as far away as possible, because the depth resolution at a
/// distance is proportional to it. A driver sees the ground from 4 m on, a pilot or an eye above a car from much farther.
double nearPlaneM(const simulation::ScenarioObject& ownship, const FrameRequest& frames)
{
    return ownship.isAirborne() || frames.eye == EyePoint::above ? 5.0 : 1.0;
}

foundation::Result<ViewSetup> viewOf(const FrameRequest& frames, const simulation::ScenarioObject& ownship)
{
    if (!frames.viewFile.empty()) return readView(frames.viewFile);
    ViewSetup setup = singleChannel(frames.widthPx, frames.heightPx);
    setup.nearM = nearPlaneM(ownship, frames);
    return setup;
}

foundation::Outcome configure(osgTerrainROAM::RoamTerrain& terrain, const TerrainRequest& request)
{
    osgTerrainROAM::RoamDrawableSettings settings = terrain.settings();
    settings.errorTolerancePx = request.errorTolerancePx;
    settings.maxTriangles = request.maxTriangles;
    settings.morphing = request.morphing;
    settings.patchExponent = request.patchExponent.value_or(0);
    return terrain.setSettings(settings);
}

/// The memory of this process that is in use, by Linux's /proc; 0 where that is not there.
double residentMb()
{
    std::ifstream file("/proc/self/statm");
    double size = 0.0, resident = 0.0;
    if (!(file >> size >> resident)) return 0.0;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-6;
}

/// Returns the index of the entity that the camera watches. Errors: there is none of that name.
foundation::Result<std::size_t> watchedEntity(const simulation::Scenario& scenario, const std::string& name)
{
    std::string names;
    for (std::size_t i = 0; i < scenario.entities.size(); ++i)
    {
        if (name.empty() || scenario.entities[i].name == name) return i;
        names += (i > 0 ? ", " : "") + scenario.entities[i].name;
    }
    return foundation::Error{"--eye-entity", "there is no entity '" + name + "'", "write one of: " + names};
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

PlaySession::PlaySession(const PlayRequest& request, SceneTerrain terrain)
    : _request(request), _terrain(std::move(terrain))
{
}

foundation::Result<std::unique_ptr<PlaySession>>
PlaySession::create(simulation::Scenario scenario, SceneTerrain terrain, const PlayRequest& request)
{
    if (scenario.entities.empty())
        return foundation::Error{request.scenario.string(), "no ScenarioObject in Entities",
                                 "add the one whose eye shall look"};
    const auto watched = watchedEntity(scenario, request.frames.eyeEntity);
    if (!watched) return watched.error();
    const auto setup = viewOf(request.frames, scenario.entities[*watched]);
    if (!setup) return setup.error();
    if (terrain.terrain)
        if (const auto set = configure(*terrain.terrain, request.terrain); !set) return set.error();
    if (terrain.roads) setRoadTolerance(*terrain.node, request.terrain.errorTolerancePx);

    std::unique_ptr<PlaySession> session(new PlaySession(request, std::move(terrain)));
    session->_watched = *watched;
    simulation::PlayerOptions stage{session->_terrain.origin(),
                                    session->_terrain.ground(),
                                    simulation::FixedClock::forFrameRate(request.frames.perSecond),
                                    "scenario",
                                    nullptr,
                                    {},
                                    request.seed};
    if (!request.scenario.empty()) stage.scenarioName = request.scenario.string();
    if (scenario.needsRoads())
    {
        auto roads = simulation::openRoads(scenario, request.scenario.parent_path());
        if (!roads) return roads.error();
        stage.roads = std::move(*roads);
    }
    stage.motions = request.motions;
    auto player = simulation::ScenarioPlayer::create(std::move(scenario), stage);
    if (!player) return player.error();
    session->_player = std::move(*player);
    if (!request.output.motionFile.empty())
    {
        session->_log.emplace(request.output.motionFile, session->_player->scenario(), stage.scenarioName);
        session->_log->add(0.0, session->_player->entities());
    }
    auto scenery = makeScenery(request.scenery, request.frames.durationS(), session->_player->scenario(),
                               stage, session->_terrain);
    if (!scenery) return scenery.error();
    session->_scenery = *std::move(scenery);
    auto scene = ScenarioScene::create(session->_player->scenario(), session->_terrain,
                                       request.scenario.parent_path());
    if (!scene) return scene.error();
    session->_scene = std::make_unique<ScenarioScene>(std::move(*scene));
    if (session->_scenery) session->_scene->root().addChild(session->_scenery->node.root);
    session->_eye = std::make_unique<OwnshipEye>(session->_player->scenario().entities[*watched],
                                                 session->_scene->eyeIn(*watched), request.frames,
                                                 session->_terrain.ground());
    if (request.frames.isInside()) session->_scene->hide(*watched);
    if (const auto opened = session->openPictures(*setup); !opened) return opened.error();
    return session;
}

foundation::Outcome PlaySession::openPictures(const ViewSetup& setup)
{
    const std::vector<PictureShape> pictures = picturesOf(setup);
    for (const PictureShape& picture : pictures)
    {
        const auto context = osgOffscreen::OffscreenContext::create(
            {_request.frames.backend, picture.widthPx, picture.heightPx, _request.frames.samples,
             osgOffscreen::kEverythingNeeds});
        if (!context) return context.error();
        _contexts.push_back(*context);
    }
    _viewer = makeViewer(_scene->root());
    _rig = std::make_unique<ChannelRig>(*_viewer, setup, _contexts);
    keepCameraTimings(*_viewer);
    // Patches and samples between those of the raster, as roads have them, exclude each other.
    if (!_request.terrain.patchExponent && _terrain.terrain && !_terrain.roads) tunePatches();
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
    _scene->show(*_player);
    const simulation::EntityState& ownship = _player->entities()[_watched];
    scenery::Pose eye = _eye->update(ownship, 0.0);
    const double stepM = std::max(kLeastStepM, ownship.speedMps / _request.frames.perSecond);
    _patchNote = measurePatches(*_terrain.terrain, *_viewer, _contexts,
                                [&]
                                {
                                    eye.positionWorld += stepM * eye.forward();
                                    _rig->setEye(eye);
                                });
}

std::vector<std::string> PlaySession::notes() const
{
    std::vector<std::string> notes = _scene->notes();
    if (!_patchNote.empty()) notes.push_back(_patchNote);
    if (_scenery) notes.insert(notes.end(), _scenery->notes.begin(), _scenery->notes.end());
    return notes;
}

foundation::Outcome PlaySession::frame()
{
    const double frameS = 1.0 / _request.frames.perSecond;
    _scene->show(*_player);
    const auto begin = std::chrono::steady_clock::now();
    _rig->setEye(_eye->update(_player->entities()[_watched], _statistics.empty() ? 0.0 : frameS));
    _viewer->frame(_player->timeS());
    const auto end = std::chrono::steady_clock::now();
    _statistics.push_back(measured());
    _statistics.back().wallMs = std::chrono::duration<double, std::milli>(end - begin).count();
    for (auto i = _player->clock().stepsPerSecond() / _request.frames.perSecond; i > 0; --i)
    {
        _player->step();
        if (_log) _log->add(_player->timeS(), _player->entities());
    }
    for (const auto& capture : _captures)
        if (const auto outcome = capture->outcome(); !outcome) return outcome.error();
    return foundation::success();
}

FrameStatistics PlaySession::measured()
{
    FrameStatistics row;
    row.frame = static_cast<std::uint32_t>(_statistics.size());
    row.timeS = _player->timeS();
    const unsigned drawn = _viewer->getFrameStamp()->getFrameNumber();
    const CameraTimings timings = cameraTimings(*_viewer, drawn);
    row.cullMs = timings.cullMs;
    row.drawMs = timings.drawMs;
    if (_scenery) row.objects = _scenery->figures(drawn);
    row.residentMb = residentMb();
    if (!_terrain.terrain) return row;
    std::uint64_t uploadedBytes = 0;
    for (const auto& group : _terrain.terrain->statistics())
    {
        uploadedBytes += group.bytesUploaded;
        if (group.frame != drawn) continue; // an eye that has gone
        row.triangles += group.refine.triangles;
        row.splits += group.refine.splits;
        row.merges += group.refine.merges;
        row.adaptUs += group.adaptUs;
        row.maxErrorPx = std::max(row.maxErrorPx, group.refine.tolerancePx);
    }
    // A group that has gone takes its count with it.
    row.uploadBytes = uploadedBytes - std::min(uploadedBytes, _uploadedBytes);
    _uploadedBytes = uploadedBytes;
    return row;
}

foundation::Outcome PlaySession::finish()
{
    for (const auto& capture : _captures)
        if (const auto written = capture->finish(); !written) return written.error();
    return _log ? _log->finish() : foundation::success();
}

} // namespace trainer
