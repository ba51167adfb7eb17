// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/Catalogue.h"

#include <array>

#include "scenery/models/entities/StandingAircraft.h"
#include "scenery/models/houses/GableHouse.h"
#include "scenery/models/houses/Hall.h"
#include "scenery/models/houses/TownHouses.h"
#include "scenery/models/looks/BuiltInLooks.h"
#include "scenery/models/trees/Tree.h"
#include "scenery/models/vehicles/Vehicle.h"

namespace scenery::models
{

namespace
{

/// The facts of a vehicle are those that its look tells.
KindFacts factsOfVehicle(Kind kind, std::string_view name)
{
    const LookBounds& bounds = builtInLook(name)->bounds;
    return {kind, name, bounds.leastHeightM, bounds.mostHeightM, bounds.mostRadiusM};
}

std::span<const KindFacts> allFacts()
{
    static const std::array kFacts{
        KindFacts{Kind::oak, "oak", 10.0, 19.0, 8.5},
        KindFacts{Kind::birch, "birch", 10.0, 18.5, 5.5},
        KindFacts{Kind::poplar, "poplar", 17.0, 28.0, 4.5},
        KindFacts{Kind::spruce, "spruce", 15.0, 27.5, 6.0},
        KindFacts{Kind::bush, "bush", 1.5, 4.6, 3.2},
        KindFacts{Kind::familyHouse, "family-house", 6.5, 12.5, 10.5},
        KindFacts{Kind::townHouses, "town-houses", 11.0, 24.0, 23.0},
        KindFacts{Kind::barn, "barn", 7.0, 13.0, 15.0},
        KindFacts{Kind::hall, "hall", 6.5, 13.0, 27.0},
        factsOfVehicle(Kind::saloon, "saloon"),
        factsOfVehicle(Kind::van, "van"),
        factsOfVehicle(Kind::bus, "bus"),
        KindFacts{Kind::lightAircraft, "light-aircraft", 2.25, 2.8, 6.0},
        KindFacts{Kind::airliner, "airliner", 11.7, 11.8, 20.0},
        KindFacts{Kind::helicopter, "helicopter", 3.1, 3.2, 8.0},
    };
    return kFacts;
}

} // namespace

std::span<const KindFacts> kinds()
{
    return allFacts();
}

const KindFacts& factsOf(Kind kind)
{
    return allFacts()[static_cast<std::size_t>(kind)];
}

Model generate(Kind kind, std::uint64_t seed)
{
    switch (kind)
    {
    case Kind::oak:
        return makeTree(TreeKind::oak, seed);
    case Kind::birch:
        return makeTree(TreeKind::birch, seed);
    case Kind::poplar:
        return makeTree(TreeKind::poplar, seed);
    case Kind::spruce:
        return makeTree(TreeKind::spruce, seed);
    case Kind::bush:
        return makeTree(TreeKind::bush, seed);
    case Kind::familyHouse:
        return makeFamilyHouse(seed);
    case Kind::townHouses:
        return makeTownHouses(seed);
    case Kind::barn:
        return makeBarn(seed);
    case Kind::hall:
        return makeHall(seed);
    case Kind::saloon:
    case Kind::van:
    case Kind::bus:
        return makeVehicle(builtInLook(factsOf(kind).name), seed);
    case Kind::lightAircraft:
        return makeStandingAircraft(EntityKind::lightAircraft, seed);
    case Kind::airliner:
        return makeStandingAircraft(EntityKind::airliner, seed);
    case Kind::helicopter:
        return makeStandingAircraft(EntityKind::helicopter, seed);
    }
    return {};
}

} // namespace scenery::models
