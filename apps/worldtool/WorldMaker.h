// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>

#include <foundation/Result.h>

#include "worldmaking/land/Houses.h"
#include "worldmaking/land/PlanGrid.h"
#include "worldmaking/land/Runways.h"
#include "worldmaking/madeup/MadeUpMap.h"
#include "worldmaking/streets/BuildStreets.h"
#include "worldtool/Commands.h"

namespace worldtool
{

/// What a world is made of. All must outlive the maker.
struct WorldSource
{
    const Request& request;
    const worldmaking::StreetMap& streets;
    const worldmaking::LandMap& land;
    worldmaking::MapBounds bounds;
    std::span<const worldmaking::Runway> runways;
    std::size_t unusableRunways = 0;
    bool hasSea = false;                                ///< at height 0: the world says so
    std::span<const worldmaking::MadeUpPlace> places{}; ///< of a made-up map, which gets scenarios
    std::function<glm::dvec3(const glm::dvec2& degrees)> placeInScene{};
};

/// Makes the parts of a world one after the other, and writes each as it is made; world.roam comes last.
class WorldMaker
{
public:
    WorldMaker(const WorldSource& source, const worldmaking::GroundOnEarth& ground)
        : _source(source), _ground(ground)
    {
    }

    /// Errors: those of buildStreets(); files that cannot be written.
    foundation::Outcome make();

    Report report;

private:
    foundation::Outcome makeHouses(const worldmaking::MapPlane& plane, const worldmaking::RoadRoom& room);
    foundation::Outcome makeLand(const worldmaking::MapPlane& plane, const worldmaking::RoadRoom& room,
                                 const std::string& proj);
    foundation::Outcome makeEdits();
    std::optional<double> heightM(const worldmaking::MapPlane& plane, const glm::dvec2& plan) const;
    std::optional<worldmaking::MapBox> limitIn(const worldmaking::MapPlane& plane) const;
    std::filesystem::path file(const char* name) const { return _source.request.world / name; }
    std::string describe() const;

    WorldSource _source;
    const worldmaking::GroundOnEarth& _ground;
    std::vector<worldmaking::House> _houses;
    std::vector<worldmaking::Runway> _runways; ///< those on the ground
    std::vector<worldmaking::PlanRings> _strips;
    bool _hasGround = false, _hasCover = false, _hasTrees = false, _hasModels = false;
};

} // namespace worldtool
