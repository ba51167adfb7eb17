// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "scenery/buildings/StandBuildings.h"

namespace scenery
{

/// What stands along a line, or at a point.
enum class StructureKind : std::uint8_t
{
    wall,
    fence,
    powerLine, ///< lattice pylons
    poleLine,  ///< wooden poles
    railway,
    windTurbine,
    footbridge, ///< of walkers and riders
    footRamp,   ///< stairs or a ramp up to one
};

/// A structure of a map. Frame: the scene's. Units: metres.
struct Structure
{
    StructureKind kind = StructureKind::wall;
    std::vector<glm::dvec2> line; ///< one point for a wind turbine
    /// at each point of the formation of a railway, or the deck of a footbridge; empty: those of the ground
    std::vector<double> heightsM;
    double heightM = 1.2;
    double widthM = 0.4;                                 ///< of walls
    bool isBridge = false;                               ///< a railway that spans straight between its ends
    bool hasWire = false;                                ///< a railway with a contact wire
    bool isTunnel = false;                               ///< a railway in a tube
    bool isInStreet = false;                             ///< rails in the surface of a street
    bool isPortalAtStart = false, isPortalAtEnd = false; ///< of a tube
    bool isOpenLeft = false, isOpenRight = false;        ///< of a tube: it goes on over the track beside
    std::vector<double> piersM;                          ///< where a footbridge stands on piers, along it
    int treads = 0;                                      ///< of stairs, down along the line; 0: a ramp
    std::uint64_t id = 0;                                ///< chance that is the same in each run
};

using StructureTags = std::map<std::string, std::string, std::less<>>;

/// Makes the structure of a line or point with the tags of OpenStreetMap (barrier, power, railway,
/// generator:source). Nothing: the tags name none, or the line is underground. The tag `heights` of worldtool
/// gives the heights of a railway at its points, in the datum of the samples; with them, `portals` (start,
/// end, both) and `tube` (left, right, both: open to that side) tell of a tunnel, `embedded` of rails in a
/// street; and there are the kinds `footbridge`, with `piers`, and `footramp`, with `treads`. Heights of
/// others: the tag, or customary ones: walls 1.2 m, city walls 6, fences 1.2, pylons 28 m below 200 kV and 48
/// above, poles 9.5, turbines 95 to the hub.
/// Sources: the OpenStreetMap wiki; Darley, *Transmission line engineering* (220 kV: 40 to 60 m, spans of 450
/// to 550 m).
std::optional<Structure> structureOf(std::vector<glm::dvec2> line, const StructureTags& tags,
                                     std::uint64_t id);

} // namespace scenery
