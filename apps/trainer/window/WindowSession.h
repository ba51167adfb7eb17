// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <memory>

#include <osgOffscreen/FrameCapture>

#include "hud/Hud.h"
#include "hud/TextOverlay.h"
#include "input/DeviceInputs.h"
#include "input/SeatKeys.h"
#include "play/SceneInterior.h"
#include "ride/Ride.h"
#include "simulation/control/ControlSwitch.h"
#include "simulation/control/VehicleMotion.h"
#include "simulation/player/LivePlay.h"
#include "sound/Loudspeaker.h"
#include "sound/SceneSound.h"
#include "view/ChannelRig.h"
#include "view/PictureQuality.h"
#include "window/InjectedEvents.h"
#include "window/PictureTaker.h"
#include "window/PictureTimes.h"
#include "window/RunFiles.h"
#include "window/SeatCamera.h"
#include "window/SeatTexts.h"
#include "window/SeatViewer.h"
#include "window/WindowBuffer.h"
#include "window/WindowLoss.h"
#include "window/WindowWatch.h"

namespace trainer
{

/// Plays a scenario, or a ride that somebody controls, in a window in real time (decision 34). Each picture:
/// events, the steps that are due, the scene, then drawing. It ends when the window is closed, by its key,
/// and by SIGINT or SIGTERM; recordings are written always.
/// Threads: one.
class WindowSession final : private KeyTarget
{
public:
    /// `scenario`: what is played where `maker` is null. `recordInputs`: file for what the person does;
    /// empty: none.
    /// Errors: those of PlayScene, of openWindow() and of readKeyScript(); a ride that cannot begin.
    static foundation::Result<std::unique_ptr<WindowSession>>
    create(simulation::Scenario scenario, SceneTerrain terrain, const PlayRequest& request, RideMaker* maker,
           const std::filesystem::path& recordInputs);
    ~WindowSession() override;

    /// Returns when it has ended. Errors: a file that cannot be written.
    foundation::Outcome run();

    /// Of the last ride; null without one.
    std::shared_ptr<simulation::VehicleMotion> motion() const { return _ride.motion; }

private:
    WindowSession(const PlayRequest& request, RideMaker* maker, const std::filesystem::path& recordInputs);
    foundation::Outcome open(simulation::Scenario scenario, SceneTerrain terrain);
    void beginCoarse();
    foundation::Outcome openPictures();
    double wallS() const;
    void injectEvents(double wallS);
    void showPicture();
    void afterEvents();
    void fitToWindow();
    void look(double wallS);
    void openSound();
    void sound();
    void measurePicture(std::chrono::steady_clock::time_point begun, double usedMs);
    void drawAsChosen();
    foundation::Outcome openDevices();
    void readDevicesNow();
    void restart(std::size_t place);
    void tell(const std::string& text);
    void tellImpacts();
    void showTexts(double wallS);
    void waitForNext(std::chrono::steady_clock::time_point begun) const;
    void finishCapture();
    foundation::Outcome finish();

    // KeyTarget
    void holdInput(std::string_view input, double direction) override;
    void addToInput(std::string_view input, double amount) override;
    void flipInput(std::string_view input) override;
    void act(KeyAction action, double amount) override;
    void handOver();
    void handOverSeat();
    void toggleFullscreen();
    bool isHudShown() const;
    void followSeat();
    void tellSeat();
    void tellRefusal();
    std::optional<simulation::InputTrack> recordedInputs() const;
    const simulation::VehicleMotion* motionOfOwnship() const;
    const simulation::DynamicVehicle* instrumented() const;

    PlayRequest _request;
    RideMaker* _maker;
    KeyScope _vehicle;
    Ride _ride; ///< without a maker: its scenario alone
    std::size_t _place = 0;
    std::size_t _impactsTold = 0;                  ///< of this ride
    std::shared_ptr<simulation::PersonSeat> _seat; ///< in a scenario; null: a ride, or nobody may sit there
    bool _hasSat = false;                          ///< somebody has, in this window
    std::string _refusalTold;                      ///< of the seat
    RunFiles _files;
    std::unique_ptr<WindowLoss> _loss; ///< until all that speaks with the window is gone
    PlayScene _play;
    std::unique_ptr<simulation::LivePlay> _live;
    osg::ref_ptr<osgViewer::GraphicsWindow> _window;
    osg::ref_ptr<SeatViewer> _viewer;
    std::unique_ptr<ChannelRig> _rig;
    std::unique_ptr<SeatCamera> _camera;
    std::unique_ptr<SceneInterior> _interior; ///< null: one does not sit inside, or it is off
    std::unique_ptr<SeatKeys> _keys;
    std::unique_ptr<Devices> _devices;
    std::unique_ptr<DeviceInputs> _deviceInputs;
    TextOverlay _overlay;
    std::unique_ptr<SceneSound> _sound;
    std::unique_ptr<Loudspeaker> _speaker; ///< null: muted
    std::unique_ptr<Hud> _hud;             ///< null without a vehicle
    std::optional<bool> _isHudWanted;      ///< absent: where no instruments of a cockpit are seen
    osg::ref_ptr<PictureTaker> _pictures;
    std::unique_ptr<osgOffscreen::FrameCapture> _capture;
    osg::ref_ptr<WindowBuffer> _buffer; ///< of captured pictures, that they are those without a window
    std::unique_ptr<WindowWatch> _watch;
    std::unique_ptr<InjectedEvents> _injected;
    std::chrono::steady_clock::time_point _begun;
    double _lastWallS = 0.0;
    SeatTexts _texts;
    PictureTimes _times;
    PictureQuality _quality;
    foundation::Outcome _failed = foundation::success(); ///< of a reset, or of captured pictures
    int _oldPlace[4] = {0, 0, 0, 0};                     ///< of the window before it covered the screen
    bool _isCovering = false, _isEnded = false, _isHidden = false;
};

} // namespace trainer
