// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <osgViewer/Viewer>

#include <osgOffscreen/FrameCapture>

#include "OwnshipEye.h"
#include "PlayRequest.h"
#include "ScenarioScene.h"
#include "SceneScenery.h"
#include "view/ChannelRig.h"
#include "view/FrameStatistics.h"

namespace trainer
{

/// A scenario being played offscreen, frame by frame.
/// Deterministic: the pictures depend on scenario, terrain and request; only the times measured do not.
class PlaySession
{
public:
    /// `terrain`: what openScene() gave. Errors: whatever keeps scenario, view, graphics or folders from being used; a
    /// scenario without entities.
    static foundation::Result<std::unique_ptr<PlaySession>>
    create(simulation::Scenario scenario, SceneTerrain terrain, const PlayRequest& request);

    /// Draws the present moment, then lets one frame's time pass. Errors: a picture that could not be written.
    foundation::Outcome frame();

    bool isFinished() const { return _player->isFinished(); }
    const std::vector<FrameStatistics>& statistics() const { return _statistics; }
    const simulation::ScenarioPlayer& player() const { return *_player; }

    /// What is not as the scenario asks, and what was measured before it began, one line each.
    std::vector<std::string> notes() const;

    /// Waits for the last pictures.
    foundation::Outcome finish();

private:
    PlaySession(const PlayRequest& request, SceneTerrain terrain);
    foundation::Outcome openPictures(const ViewSetup& setup);
    foundation::Outcome beginCaptures(const ViewSetup& setup);
    void tunePatches();
    FrameStatistics measured() const;

    PlayRequest _request;
    SceneTerrain _terrain;
    std::unique_ptr<simulation::ScenarioPlayer> _player;
    std::unique_ptr<ScenarioScene> _scene;
    std::optional<SceneScenery> _scenery;
    std::unique_ptr<OwnshipEye> _eye;
    osg::ref_ptr<osgViewer::Viewer> _viewer;
    std::vector<osg::ref_ptr<osg::GraphicsContext>> _contexts;
    std::unique_ptr<ChannelRig> _rig;
    std::vector<std::unique_ptr<osgOffscreen::FrameCapture>> _captures;
    std::vector<FrameStatistics> _statistics; ///< of the frames drawn so far
    std::string _patchNote;
};

} // namespace trainer
