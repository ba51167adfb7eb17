// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace osgRoads::core
{

/// The words of OpenDRIVE for the values of an enumeration. The first word of a value is the one to write.
template<class Value, std::size_t Count>
using Keywords = std::array<std::pair<std::string_view, Value>, Count>;

/// What a lane is for. Source: ASAM OpenDRIVE 1.8, 11.3 (lane types); the words that only older versions have
/// are kept.
enum class LaneType
{
    none,
    driving,
    stop,
    shoulder,
    biking,
    sidewalk,
    border,
    restricted,
    parking,
    bidirectional,
    median,
    special,
    roadWorks,
    tram,
    rail,
    entry,
    exit,
    offRamp,
    onRamp,
    connectingRamp,
    slipLane,
    bus,
    taxi,
    hov,
    curb,
    shared,
};

inline constexpr Keywords<LaneType, 31> kLaneTypes = {{{"none", LaneType::none},
                                                       {"driving", LaneType::driving},
                                                       {"stop", LaneType::stop},
                                                       {"shoulder", LaneType::shoulder},
                                                       {"biking", LaneType::biking},
                                                       {"sidewalk", LaneType::sidewalk},
                                                       {"walking", LaneType::sidewalk},
                                                       {"border", LaneType::border},
                                                       {"restricted", LaneType::restricted},
                                                       {"parking", LaneType::parking},
                                                       {"bidirectional", LaneType::bidirectional},
                                                       {"median", LaneType::median},
                                                       {"special1", LaneType::special},
                                                       {"special2", LaneType::special},
                                                       {"special3", LaneType::special},
                                                       {"roadWorks", LaneType::roadWorks},
                                                       {"tram", LaneType::tram},
                                                       {"rail", LaneType::rail},
                                                       {"entry", LaneType::entry},
                                                       {"mwyEntry", LaneType::entry},
                                                       {"exit", LaneType::exit},
                                                       {"mwyExit", LaneType::exit},
                                                       {"offRamp", LaneType::offRamp},
                                                       {"onRamp", LaneType::onRamp},
                                                       {"connectingRamp", LaneType::connectingRamp},
                                                       {"slipLane", LaneType::slipLane},
                                                       {"bus", LaneType::bus},
                                                       {"taxi", LaneType::taxi},
                                                       {"HOV", LaneType::hov},
                                                       {"curb", LaneType::curb},
                                                       {"shared", LaneType::shared}}};

/// Whether cars drive on lanes of this type.
bool isForCars(LaneType type);

/// The word of OpenDRIVE for a type.
std::string_view wordOf(LaneType type);

} // namespace osgRoads::core
