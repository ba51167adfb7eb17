// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <utility>

#include <osgSession/Session>

#include <osgOffscreen/PngFile>

#include "WorldRide.h"
#include "core/PlayParts.h"
#include "core/RideScenario.h"
#include "play/PlaySession.h"
#include "scene/DriveWay.h"
#include "scene/RideRoads.h"
#include "scene/ScenarioStage.h"
#include "simulation/control/scenario/VehicleFiles.h"
#include "simulation/scenario/SessionTraffic.h"
#include "simulation/track/LayRecordings.h"

namespace osgSession
{

class Session::Parts
{
public:
    std::unique_ptr<trainer::PlaySession> session;
    std::unique_ptr<core::Play> play; ///< of the session's player
    double drawnAtS = 0.0;            ///< the last picture

    double sinceDrawnS()
    {
        const double nowS = play->timeS(), sinceS = nowS - drawnAtS;
        drawnAtS = nowS;
        return sinceS;
    }
};

namespace
{

trainer::Quality qualityOf(PictureQuality quality)
{
    switch (quality)
    {
    case PictureQuality::low:
        return trainer::Quality::low;
    case PictureQuality::medium:
        return trainer::Quality::medium;
    case PictureQuality::reference:
        return trainer::Quality::reference;
    case PictureQuality::high:
        break;
    }
    return trainer::Quality::high;
}

trainer::EyePoint eyePointOf(EyeFrom from)
{
    switch (from)
    {
    case EyeFrom::behind:
        return trainer::EyePoint::chase;
    case EyeFrom::above:
        return trainer::EyePoint::above;
    case EyeFrom::tower:
        return trainer::EyePoint::tower;
    case EyeFrom::kerb:
        return trainer::EyePoint::kerb;
    case EyeFrom::map:
        return trainer::EyePoint::map;
    case EyeFrom::free:
        return trainer::EyePoint::free;
    case EyeFrom::inside:
        break;
    }
    return trainer::EyePoint::own;
}

trainer::PlayRequest requestOf(const SessionSettings& settings)
{
    trainer::PlayRequest request;
    request.scenario = settings.play.scenario;
    request.trafficPerKm = settings.trafficPerKm;
    request.seed = settings.play.seed;
    if (settings.play.isWithoutRoads) request.without = simulation::WithoutRoads::played;
    request.terrain.file = settings.world;
    request.frames.widthPx = settings.picture.widthPx;
    request.frames.heightPx = settings.picture.heightPx;
    request.frames.samples = settings.picture.samples;
    request.frames.quality = qualityOf(settings.picture.quality);
    request.frames.hasShadows = settings.picture.hasShadows;
    request.terrain.errorTolerancePx = trainer::rulesOf(request.frames.quality).tolerancePx;
    return request;
}

foundation::Outcome checkPicture(const PictureSettings& picture)
{
    constexpr int kMostPx = 16'384;
    const bool hasPixels = picture.widthPx > 0 && picture.heightPx > 0;
    if (hasPixels && picture.widthPx <= kMostPx && picture.heightPx <= kMostPx) return foundation::success();
    return foundation::Error{"PictureSettings",
                             std::to_string(picture.widthPx) + " x " + std::to_string(picture.heightPx) +
                                 " is no size of a picture",
                             "give 1 to " + std::to_string(kMostPx) + " pixels"};
}

foundation::Outcome checkTraffic(const SessionSettings& settings)
{
    const double perKm = settings.trafficPerKm;
    if (!(perKm >= 0.0 && perKm <= simulation::SessionTraffic::kMostPerKm))
        return foundation::Error{"SessionSettings",
                                 std::to_string(perKm) + " vehicles a kilometre are no traffic",
                                 "give 0 to 60"};
    if (perKm > 0.0 && !settings.play.scenario.empty())
        return foundation::Error{"SessionSettings", "a scenario has the traffic that it says",
                                 "leave trafficPerKm at 0, or write a TrafficAction into the scenario"};
    return foundation::success();
}

/// Tells a host how far an opening is.
class OpeningTeller final : public trainer::OpeningWatch
{
public:
    using Tell = std::function<void(std::string_view stage, double share)>;

    explicit OpeningTeller(Tell tell) : _tell(std::move(tell)) {}

    void hasEnded(std::string_view stage) override
    {
        for (const auto& [name, share] : kShares)
            if (name == stage) _share = std::max(_share, share);
        _tell(stage, _share);
    }

private:
    /// Measured on the default world, opened again.
    static constexpr std::array<std::pair<std::string_view, double>, 8> kShares = {
        {{"program", 0.01},
         {"ground", 0.3},
         {"land", 0.5},
         {"what stands on it", 0.85},
         {"scenario", 0.87},
         {"entities", 0.93},
         {"cover", 0.98},
         {"contexts", 1.0}}};

    Tell _tell;
    double _share = 0.0;
};

/// What is played, and on what.
struct Staged
{
    simulation::Scenario scenario;
    trainer::SceneTerrain terrain;
    std::shared_ptr<const simulation::Ground> wheels;
    std::vector<std::string> notes;
};

foundation::Result<Staged> stageScenario(const SessionSettings& settings, const trainer::PlayRequest& request)
{
    Staged staged;
    auto scenario = core::readForPlay(settings.play, staged.notes);
    if (!scenario) return scenario.error();
    auto terrain = trainer::openStage(*scenario, request);
    if (!terrain) return terrain.error();
    staged.terrain = std::move(*terrain);
    const simulation::SceneFrame frame(staged.terrain.origin(), staged.terrain.ground());
    const auto laid = simulation::layRecordings(*scenario, {request.scenario, &frame});
    if (!laid) return laid.error();
    staged.notes.insert(staged.notes.end(), laid->begin(), laid->end());
    staged.scenario = std::move(*scenario);
    staged.wheels = trainer::groundForWheels(staged.terrain);
    return staged;
}

foundation::Result<Staged> stageRide(const SessionSettings& settings, const trainer::PlayRequest& request)
{
    if (settings.world.empty() || settings.vehicle.empty())
        return foundation::Error{"SessionSettings", "there is neither a scenario nor a ride",
                                 "name a scenario, or a world and a vehicle"};
    if (const auto usable = core::checkSteps(settings.play); !usable) return usable.error();
    const auto vehicle = simulation::openVehicle(settings.vehicle, std::nullopt, settings.play.seed);
    if (!vehicle) return vehicle.error();
    if (const auto usable = trainer::checkElevation(settings.world, request.terrain); !usable)
        return usable.error();
    auto terrain = trainer::openElevation(settings.world, request.terrain);
    if (!terrain) return terrain.error();
    Staged staged;
    staged.terrain = std::move(*terrain);
    staged.wheels = trainer::groundForWheels(staged.terrain);
    auto scenario = rideInWorld(staged.terrain, *staged.wheels, settings.world, **vehicle, settings.startM);
    if (!scenario) return scenario.error();
    staged.scenario = std::move(*scenario);
    return staged;
}

/// Traffic around a ride, and the lights of its roads.
void addRoads(trainer::PlayRequest& request, Staged& staged)
{
    using simulation::SessionTraffic;
    trainer::addRoads(request, staged.terrain);
    staged.scenario.roadNetwork.signalControllers = request.lights;
    if (!request.trafficRoads) return;
    const bool flies = staged.scenario.entities.front().isAirborne();
    simulation::addTraffic(
        staged.scenario, core::kRideEntity,
        {request.trafficPerKm, flies ? SessionTraffic::kAroundAircraftM : SessionTraffic::kAroundVehicleM});
}

} // namespace

Session::Session(std::unique_ptr<Parts> parts) : _parts(std::move(parts)) {}

Session::~Session() = default;

foundation::Result<std::unique_ptr<Session>> Session::open(const SessionSettings& settings)
{
    if (const auto usable = checkPicture(settings.picture); !usable) return usable.error();
    if (const auto usable = checkTraffic(settings); !usable) return usable.error();
    trainer::PlayRequest request = requestOf(settings);
    const auto teller = std::make_shared<OpeningTeller>(settings.progress);
    if (settings.progress)
        request.terrain.opening->watchBy([told = std::weak_ptr<trainer::OpeningWatch>(teller)](
                                             const std::string&) { return told.lock(); });
    const bool isRide = settings.play.scenario.empty();
    auto staged = isRide ? stageRide(settings, request) : stageScenario(settings, request);
    if (!staged) return staged.error();
    if (isRide) addRoads(request, *staged);
    core::PlaySettings play = settings.play;
    if (isRide) play.driven = {{core::kRideEntity, settings.vehicle}};
    auto parts = std::make_unique<core::Play::Parts>();
    auto driven = core::makeDriven(play, staged->scenario, staged->wheels, staged->terrain.origin());
    if (!driven) return driven.error();
    parts->driven = std::move(*driven);
    if (request.trafficRoads)
        for (const auto& [entity, vehicle] : parts->driven)
            vehicle.motion()->meetOthers();
    parts->notes = std::move(staged->notes);
    request.motions = core::motionsOf(parts->driven);
    auto session = trainer::PlaySession::create(std::move(staged->scenario), std::move(staged->terrain),
                                                request, simulation::FixedClock(play.stepsPerSecond));
    if (!session) return session.error();
    const std::vector<std::string> notes = (*session)->notes();
    parts->notes.insert(parts->notes.end(), notes.begin(), notes.end());
    parts->player = &(*session)->player();
    auto made = std::make_unique<Parts>();
    made->session = std::move(*session);
    made->play = std::make_unique<core::Play>(std::move(parts));
    return std::unique_ptr<Session>(new Session(std::move(made)));
}

core::Play& Session::play()
{
    return *_parts->play;
}

foundation::Outcome Session::look(const Eye& eye)
{
    return _parts->session->setEye(eyePointOf(eye.from), eye.entity,
                                   {eye.place, eye.headingDeg, eye.pitchDeg});
}

osg::ref_ptr<osg::Image> Session::picture()
{
    return _parts->session->picture(_parts->sinceDrawnS());
}

foundation::Outcome Session::savePicture(const std::filesystem::path& file)
{
    return osgOffscreen::writePng(*picture(), file);
}

} // namespace osgSession
