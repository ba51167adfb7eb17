// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <span>

#include <foundation/Heights.h>
#include <foundation/Result.h>

#include <osgTerrainROAM/core/edit/Earthworks.h>

#include "terminal/Progress.h"
#include "worldmaking/land/CoverRaster.h"
#include "worldmaking/land/Houses.h"
#include "worldmaking/land/LandUse.h"
#include "worldmaking/land/Runways.h"
#include "worldmaking/madeup/MadeUpMap.h"
#include "worldmaking/plan/PlanGrid.h"
#include "worldmaking/streets/BuildStreets.h"
#include "worldtool/BuildState.h"
#include "worldtool/Commands.h"
#include "worldtool/LandCover.h"

namespace worldtool
{

/// What trees bear in a made-up world, where it is not what the place would have.
struct WorldClimate
{
    double aridity = 0.12, treeLineM = 2000.0;
};

/// What a world is made of. All must outlive the maker.
struct WorldSource
{
    const Request& request;
    const worldmaking::StreetMap& streets;
    const worldmaking::LandMap& land;
    worldmaking::MapBounds bounds;
    std::span<const worldmaking::Runway> runways;
    std::size_t unusableRunways = 0;
    bool hasSea = false; ///< at height 0: the world says so
    const char* water =
        nullptr; ///< what else is water than the map's: the word of a .roam file; null: the usual
    std::span<const worldmaking::MadeUpPlace> places{}; ///< of a made-up map, which gets scenarios
    std::function<glm::dvec3(const glm::dvec2& degrees)> placeInScene{};
    std::optional<WorldClimate> climate{}; ///< absent: that of the place
    CoverOnEarth coverAt{};                ///< empty: there is no raster of it
};

/// A step of a build, and the per cent of the time of a build that it takes: measured on a gentle degree
/// tile.
struct BuildStep
{
    const char* name;
    std::size_t share;
};
inline constexpr BuildStep kGround{"elevation", 2}, kMap{"map", 32}, kEarth{"waters and airfields", 1},
    kStreets{"streets", 2}, kHouses{"houses", 1}, kLand{"land cover", 2}, kTrees{"trees", 8},
    kEdits{"ground below the roads", 52};

/// Makes the parts of a world one after the other, and writes each as it is
/// made; world.roam comes last.
class WorldMaker
{
public:
    /// `progress`: that of the build; it must outlive the maker.
    WorldMaker(const WorldSource& source, const foundation::HeightOnEarth& ground, BuildState state,
               terminal::Progress& progress)
        : _source(source), _ground(ground), _state(std::move(state)), _progress(progress)
    {
    }

    /// Errors: those of buildStreets(); files that cannot be written.
    foundation::Outcome make();

    Report report;

private:
    /// Writes a file of the world unless it is made already.
    template<class Write>
    foundation::Outcome part(const char* name, const Write& write)
    {
        if (!_state.has(name))
        {
            if (const foundation::Outcome written = write(file(name)); !written) return written;
            if (const auto noted = _state.note(name); !noted) return noted;
        }
        return foundation::success();
    }
    foundation::Outcome makeEarth();
    void shapeGround();
    void addTrackWorks(const worldmaking::MapPlane& plane);
    void addTubeWorks(const worldmaking::Track& track, const worldmaking::MapPlane& plane,
                      std::vector<osgTerrainROAM::core::Earthwork>& works) const;
    foundation::Outcome writeEarth();
    foundation::Result<worldmaking::Streets> makeStreets(const std::string& mapName) const;
    void fillCover(worldmaking::CoverRaster& cover, const worldmaking::MapPlane& plane,
                   const worldmaking::RoadRoom& room, worldmaking::LandReport& land) const;
    foundation::Outcome makeHouses(const worldmaking::MapPlane& plane, const worldmaking::RoadRoom& room);
    foundation::Outcome makeLand(const worldmaking::MapPlane& plane, const worldmaking::RoadRoom& room,
                                 const std::string& proj);
    foundation::Outcome makeEdits();
    std::vector<osgTerrainROAM::core::Earthwork> waterWorksIn(const worldmaking::MapPlane& plane) const;
    std::optional<double> heightM(const worldmaking::MapPlane& plane, const glm::dvec2& plan) const;
    std::optional<worldmaking::MapBox> limitIn(const worldmaking::MapPlane& plane) const;
    std::filesystem::path file(const char* name) const { return _source.request.world / name; }
    std::string describe() const;

    WorldSource _source;
    const foundation::HeightOnEarth& _ground;
    BuildState _state;
    void begin(const BuildStep& step) { _progress.begin(step.name, step.share); }

    terminal::Progress& _progress;
    foundation::HeightOnEarth _shaped;                        ///< with its earthworks
    worldmaking::LandMap _land;                               ///< with its waters cut to their level
    std::vector<osgTerrainROAM::core::Earthwork> _waterWorks; ///< their paths in degrees
    std::vector<worldmaking::House> _houses;
    std::vector<worldmaking::Runway> _runways; ///< those on the ground
    std::vector<worldmaking::PlanRings> _strips;
    std::shared_ptr<const worldmaking::MapPlane> _earthPlane;
    std::vector<osgTerrainROAM::core::Earthwork> _works; ///< all, in that plane
    std::vector<worldmaking::Track> _tracks;             ///< in the plane of the roads
    std::vector<worldmaking::Footbridge> _footbridges;   ///< likewise
    bool _hasGround = false, _hasCover = false, _hasTrees = false, _hasEarth = false, _hasStructures = false;
    bool _hasModels = false, _hasRoads = true;
};

} // namespace worldtool
