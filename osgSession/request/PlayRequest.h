// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <viewlod/Budget.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/method/Method.h>

#include <osgOffscreen/Backend>

#include "scenery/lights/LightSteps.h"
#include "simulation/environment/CloudLayer.h"
#include "simulation/road/WithoutRoads.h"
#include "simulation/scenario/Environment.h"
#include "simulation/scenario/TrafficSignals.h"
#include "view/HudUnits.h"
#include "view/OpeningClock.h"
#include "view/Quality.h"

namespace simulation
{
class ExternalMotion;
class RoadScene;
} // namespace simulation

namespace trainer
{

/// The eye point of the camera.
enum class EyePoint
{
    own,    ///< the eye of the ownship's driver or pilot
    driver, ///< the same; a tour is a drive then
    pilot,  ///< the same; a tour is a flight then
    chase,  ///< a camera behind and above the ownship
    above,  ///< a camera high above a car, which looks down ahead of it
    tower,  ///< one that stands beside the way, high up, and turns after the ownship
    kerb,   ///< the same at the height of a person at the kerb
    free,   ///< where the request says
    map,    ///< straight down from high above the ownship, north up
};

/// Whether the eye keeps its distance to the ownship, and so has its speed.
constexpr bool movesWithOwnship(EyePoint eye)
{
    return eye != EyePoint::tower && eye != EyePoint::kerb && eye != EyePoint::free;
}

/// A camera of fixed place and direction. Frame: the scene's east-north-up. Units: metres, degrees.
struct FreeEye
{
    glm::dvec3 place{0.0, 0.0, 2.0};
    double headingDeg = 0.0; ///< counter-clockwise from east
    double pitchDeg = 0.0;   ///< upwards
};

/// A level strip that is laid into the ground. Frame: the scene's. Units: metres.
struct StripRequest
{
    glm::dvec2 threshold{0.0}; ///< middle of the end at which one lands
    double courseDeg = 0.0;    ///< from north, clockwise
    double lengthM = 800.0, widthM = 30.0;
};

/// The usual limit of the terrain's triangles.
inline constexpr std::uint32_t kDefaultMaxTriangles = 500000;

/// The terrain and how it is drawn.
struct TerrainRequest
{
    std::filesystem::path file; ///< replaces the scenario's scene; empty: the scenario's scene
    osgTerrainROAM::core::DemImportOptions import;
    std::optional<StripRequest> strip{}; ///< absent: none is laid
    bool showsVoids = false;             ///< colours the ground that fills voids
    bool inRoadsFrame =
        false; ///< an OpenDRIVE network keeps its own frame, in which scenarios place entities
    std::optional<osgTerrainROAM::core::Method> method{}; ///< of level of detail; absent: the terrain's own
    double errorTolerancePx = 1.0;
    std::optional<std::uint32_t>
        maxTriangles{};    ///< absent: kDefaultMaxTriangles, or none where the method needs more
    bool morphing = false; ///< vertices move to their new position during several frames
    /// refines only what is seen and so much beside it; absent: as the
    std::optional<double> viewMarginDeg{};
    ///< terrain's file says
    /// of each frame, for adapting a mesh; absent: as the terrain's file says
    std::optional<double> adaptTimeUs{};
    viewlod::Budget::Clock adaptClock = viewlod::Budget::Clock::modelled; ///< pictures repeat
    std::optional<int> patchExponent =
        0;                       ///< 2^k triangles a leaf; absent: measured to be the fastest on this machine
    bool wantsObstacles = false; ///< gathers what vehicles may hit (SceneTerrain::obstacles)
    std::shared_ptr<OpeningClock> opening = std::make_shared<OpeningClock>(); ///< measures how long it takes
};

/// The frames: how many, of which size, through which camera.
struct FrameRequest
{
    osgOffscreen::Backend backend = osgOffscreen::defaultBackend();
    std::filesystem::path viewFile; ///< describes the channels; empty: one channel of widthPx by heightPx
    int widthPx = 960;
    int heightPx = 540;
    int samples = 4; ///< per pixel
    EyePoint eye = EyePoint::own;
    std::string eyeEntity;            ///< the entity that is watched; empty: as watchedEntity()
    FreeEye freeEye;                  ///< with EyePoint::free
    bool hasShadows = true;           ///< of the sun, by maps
    scenery::LightSteps lightSteps{}; ///< of lamps
    Quality quality = Quality::high;
    std::optional<double>
        eyeHeightM; ///< of a driver above the ground, or of the eye above the car; absent: a usual one
    /// whether the inside of the vehicle is drawn; absent: where somebody sits in it by name or in a window
    std::optional<bool> interior;
    int perSecond = 24;
    std::optional<int> count; ///< absent: until the scenario ends

    /// Whether the camera is in the ownship, which then is not drawn.
    bool isInside() const
    {
        return eye == EyePoint::own || eye == EyePoint::driver || eye == EyePoint::pilot;
    }

    /// Whether the inside of the vehicle is drawn. A view file has none: its channels are the windows of a
    /// cockpit.
    bool showsInterior(bool hasWindow) const
    {
        return isInside() && viewFile.empty() && interior.value_or(hasWindow || eye != EyePoint::own);
    }

    /// The simulated time of `count` frames, in seconds; 0 where it is absent.
    double durationS() const { return count.value_or(0) / static_cast<double>(perSecond); }
};

/// The objects on the terrain. Empty paths: none.
struct SceneryRequest
{
    std::filesystem::path description;  ///< a scenery file
    std::filesystem::path modelsFolder; ///< its models form one more field

    bool isEmpty() const { return description.empty() && modelsFolder.empty(); }

    /// The path that an error of the scenery names.
    std::string name() const { return (description.empty() ? modelsFolder : description).string(); }
};

/// The files that a play writes. Empty paths: not written.
struct OutputRequest
{
    std::filesystem::path captureFolder;
    std::filesystem::path statsFile;
    std::filesystem::path reportFile;
    std::string contactSheet;           ///< image file beside the report that the report shows
    std::string video;                  ///< video file beside the report that the report shows
    std::filesystem::path partsFile{};  ///< what the parts of a picture cost
    std::filesystem::path motionFile{}; ///< a row for each step with the motion of every entity
};

/// What is heard.
struct SoundRequest
{
    bool isMuted = false;
    std::filesystem::path file; ///< of what is heard in offscreen pictures; empty: none
};

/// The window that shows a play in real time.
struct WindowRequest
{
    bool isWanted = false; ///< else pictures are offscreen, if there are any
    bool isFullscreen = false;
    int screen = 0;
    std::vector<int> place; ///< x, y, width, height in pixels; empty: anywhere, with the size of the frames
    std::filesystem::path picturesFolder = "."; ///< for those that a key asks for
    std::filesystem::path devicesFile;          ///< what joysticks and wheels are for; empty: the usual
    std::filesystem::path keysFile;             ///< a test aid: keys at times
    bool byKeys = false; ///< a test aid: the autopilot or driver presses the keys of a person
    HudUnits units = HudUnits::usual;
    bool choosesSamples = true;   ///< none was asked for: one where a processor draws
    bool choosesQuality = true;   ///< none was asked for, nothing is captured: as pictures are quick
    bool choosesTolerance = true; ///< none was asked for, nothing is captured: as pictures are quick
    double pictureS = 0.0;        ///< a test aid: each picture counts as so long; 0: the wall clock
};

/// A person in an entity of a scenario. Empty paths: none.
struct SeatRequest
{
    /// empty: that of a manual controller, or in a window the watched one
    std::string entity;
    bool isTakenAtStart = false;     ///< else when somebody takes over, or the storyboard asks
    std::filesystem::path vehicle{}; ///< its data file; empty: by the entity's category
    std::filesystem::path inputs{};  ///< what was recorded, in place of a person's hands
    std::filesystem::path recordInputs{};
};

/// The arguments of `trainer play`, `trainer tour` and what pictures show of a vehicle that is flown or
/// driven.
struct PlayRequest
{
    std::filesystem::path scenario;                  ///< empty in a tour
    std::map<std::string, std::string> parameters{}; ///< values instead of the scenario's
    TerrainRequest terrain;
    FrameRequest frames;
    SceneryRequest scenery;
    OutputRequest output;
    WindowRequest window{};
    SoundRequest sound{};
    std::optional<std::vector<simulation::CloudLayer>>
        clouds{};                                       ///< in place of the scenario's and the world's
    std::optional<simulation::Weather> weather{};       ///< holds from the begin on, after the scenario's
    std::optional<simulation::SurfaceWeather> ground{}; ///< the same

    /// What moves entities in place of their actions. The play ends when all their controllers have done what
    /// they were told.
    std::map<std::string, std::shared_ptr<simulation::ExternalMotion>> motions{};
    std::shared_ptr<const simulation::RoadScene> roadsUnder{}; ///< as PlayerOptions has them
    std::optional<SeatRequest> seat{};                         ///< absent: nobody sits anywhere
    double trafficPerKm = 0.0; ///< vehicles a kilometre of street around a ride
    /// where that traffic drives, in the scene's frame; null: nowhere. The steps of the play are then those
    /// of a seat.
    std::shared_ptr<const simulation::RoadScene> trafficRoads{};
    std::vector<simulation::TrafficSignalController> lights{}; ///< of the roads of a ride
    double longestS = 3600.0;                                  ///< limit for a scenario that never ends
    std::uint64_t seed = 0;                                    ///< of what the player leaves to chance
    simulation::WithoutRoads without = simulation::WithoutRoads::refused;
};

} // namespace trainer
