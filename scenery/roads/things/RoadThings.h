// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Heights.h>
#include <glm/mat3x3.hpp>

#include <osgRoads/core/place/PlacedNetwork.h>

#include "scenery/models/Catalogue.h"
#include "scenery/models/roads/RoadModel.h"
#include "simulation/contact/ObstacleMap.h"

namespace scenery::roads
{

/// A model where it stands. Frame: the scene's; columns of `axes` are the model's x, y and z.
struct StandingThing
{
    std::size_t model = 0; ///< into RoadThings::models, or ::grown
    glm::dvec3 position{0.0};
    glm::dmat3 axes{1.0};
    double scale = 1.0;
    std::string signalId; ///< of a traffic light
};

/// A model that is made for one place: a guard rail, a building, a bridge. Frame: the scene's axes about
/// `origin`.
struct OwnThing
{
    models::Model model;
    glm::dvec3 origin{0.0};
};

/// A lamp that shines downwards: a rectangle, seen from below. Frame: the scene's. Units: metres.
struct CeilingLamp
{
    glm::dvec3 middle{0.0};
    glm::dvec3 along{1.0, 0.0, 0.0}; ///< horizontal unit vector of its length
    double lengthM = 1.0, widthM = 0.3;
};

/// A generated plant.
struct GrownModel
{
    models::Kind kind = models::Kind::bush;
    std::uint64_t seed = 1;
    auto operator<=>(const GrownModel&) const = default;
};

/// All that stands beside and over the roads of a network.
struct RoadThings
{
    std::vector<models::RoadModel> models;
    std::vector<StandingThing> standing;
    std::vector<GrownModel> grown;
    std::vector<StandingThing> plants;
    std::vector<OwnThing> own;
    std::vector<CeilingLamp> lamps;
    /// of what is made along a road: rails, walls, tunnels, piers; buildings
    simulation::ObstacleList bodies;
    std::map<models::RoadModel, std::size_t> modelIndex; ///< of `models`
};

/// Places signals, objects, bridges and tunnels. Without `ground` everything stands at the height of its
/// road. Posts stand upright, what they carry is pitched and rolled as told, other objects as a whole;
/// `orientation` - turns a signal by half a turn; one that holds for both directions shows its face on both
/// sides. Signals with a pole object within 0.5 m have no post of their own. Objects without a model are grey
/// boxes of their size.
/// Source: ASAM OpenDRIVE 1.8, 13 and 14. Cost: linear.
RoadThings placeRoadThings(const osgRoads::core::PlacedNetwork& placed,
                           const foundation::HeightInPlan& ground = {});

} // namespace scenery::roads
