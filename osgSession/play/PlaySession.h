// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <osgViewer/Viewer>

#include <osgOffscreen/FrameCapture>

#include "OwnshipEye.h"
#include "PictureParts.h"
#include "PlayScene.h"
#include "SceneInterior.h"
#include "simulation/record/MotionLog.h"
#include "sound/SoundTrack.h"
#include "view/ChannelRig.h"
#include "view/FrameStatistics.h"

namespace trainer
{

/// Plays a scenario offscreen, frame by frame.
/// Deterministic: the frames depend on scenario, terrain and request; only the measured times differ.
class PlaySession
{
public:
    /// `terrain`: from openScene(). Errors: a scenario, view, graphics context or folder that cannot be used;
    /// a scenario without entities.
    static foundation::Result<std::unique_ptr<PlaySession>>
    create(simulation::Scenario scenario, SceneTerrain terrain, const PlayRequest& request);

    /// The same with another clock than that of the frames.
    static foundation::Result<std::unique_ptr<PlaySession>> create(simulation::Scenario scenario,
                                                                   SceneTerrain terrain,
                                                                   const PlayRequest& request,
                                                                   const simulation::FixedClock& clock);

    /// Draws the current state, then advances the scenario by the time of one frame. Errors: an image that
    /// cannot be written.
    foundation::Outcome frame();

    /// Draws the current state. `dtS`: since the last picture.
    void draw(double dtS);

    /// Draws and returns the picture of the first channel; RGB, bottom row first.
    osg::ref_ptr<osg::Image> picture(double dtS);

    /// Looks from somewhere else from the next picture on. `entity`: as FrameRequest::eyeEntity.
    /// Errors: there is no such entity.
    foundation::Outcome setEye(EyePoint eye, const std::string& entity, const FreeEye& free);

    bool isFinished() const { return _play.player->isFinished() || _play.player->areMotionsDone(); }
    const std::vector<FrameStatistics>& statistics() const { return _statistics; }
    const simulation::ScenarioPlayer& player() const { return *_play.player; }
    simulation::ScenarioPlayer& player() { return *_play.player; }
    const PictureParts* parts() const { return _parts.get(); } ///< null: not measured

    /// Returns the differences from the scenario and the measurements made before it began, one line each.
    std::vector<std::string> notes() const;

    /// Waits until the last images are written.
    foundation::Outcome finish();

private:
    PlaySession(const PlayRequest& request, PlayScene play);
    void beginLog();
    foundation::Outcome openPictures(const ViewSetup& setup);
    void takeSeat();
    foundation::Outcome beginCaptures(const ViewSetup& setup);
    void tunePatches();
    FrameStatistics measured();
    void look(double dtS);
    void advance();
    const std::vector<simulation::EntityState>& shown() const;
    const simulation::ExternalMotion* motionOfOwnship() const;

    PlayRequest _request;
    PlayScene _play;
    std::unique_ptr<OwnshipEye> _eye;
    osg::ref_ptr<osgViewer::Viewer> _viewer;
    std::vector<osg::ref_ptr<osg::GraphicsContext>> _contexts;
    int _drawnSide = 1; ///< OffscreenContext::drawnSide() of each
    std::unique_ptr<ChannelRig> _rig;
    std::unique_ptr<SceneInterior> _interior; ///< null: not drawn
    std::vector<std::unique_ptr<osgOffscreen::FrameCapture>> _captures;
    std::vector<FrameStatistics> _statistics; ///< of the frames drawn so far
    std::uint64_t _uploadedBytes = 0;         ///< to the end of the last frame
    std::string _patchNote;
    std::int64_t _frames = 0, _steps = 0;          ///< that frame() has made
    std::vector<simulation::EntityState> _between; ///< for a picture between two steps; else empty
    std::optional<simulation::MotionLog> _log;
    std::unique_ptr<SoundTrack> _sound;   ///< null: not written
    std::unique_ptr<PictureParts> _parts; ///< null: not measured
};

} // namespace trainer
