// SPDX-License-Identifier: Apache-2.0
#include "worldtool/BuildReport.h"

namespace worldtool
{

nlohmann::ordered_json rowOf(const worldmaking::StreetReport& report)
{
    return {{"ways", report.ways},
            {"closedWays", report.closedWays},
            {"waysBeyondGround", report.waysBeyondGround},
            {"shortWays", report.shortWays},
            {"missingNodes", report.missingNodes},
            {"streets", report.streets},
            {"crossings", report.crossings},
            {"turns", report.turns},
            {"bridges", report.bridges},
            {"tunnels", report.tunnels},
            {"overpasses", report.overpasses},
            {"lostOverpasses", report.lostOverpasses},
            {"untoldOverpasses", report.untoldOverpasses},
            {"untoldBridges", report.untoldBridges},
            {"coveredCrossings", report.coveredCrossings},
            {"levelCrossings", report.levelCrossings},
            {"bareTunnels", report.bareTunnels},
            {"sharpBends", report.sharpBends},
            {"roadsKm", report.lengthKm},
            {"maxGradePercent", report.steepestPercent},
            {"steepKm", report.steepKm}};
}

nlohmann::ordered_json rowOf(const worldmaking::HouseReport& report)
{
    return {{"read", report.read},
            {"standing", report.standing},
            {"towers", report.towers},
            {"cutBack", report.cutBack},
            {"passages", report.passages},
            {"parts", report.parts},
            {"onRoad", report.onRoad},
            {"overlapping", report.overlapping},
            {"onRunway", report.onRunway},
            {"inWater", report.inWater},
            {"underground", report.underground},
            {"beyondGround", report.beyondGround},
            {"unusable", report.unusable}};
}

nlohmann::ordered_json rowOf(const worldmaking::LandReport& report, std::size_t unusedRunways)
{
    return {{"coverAreas", report.coverAreas},
            {"fields", report.fields},
            {"waters", report.waters},
            {"waterLines", report.waterLines},
            {"ways", report.ways},
            {"railways", report.railways},
            {"aprons", report.aprons},
            {"runways", report.runways},
            {"unusedRunways", unusedRunways},
            {"silentWoodsHa", report.silentWoodsHa}};
}

nlohmann::ordered_json rowOf(const worldmaking::TreeReport& report)
{
    return {{"inWoods", report.inWoods},       {"single", report.single}, {"inRows", report.inRows},
            {"inOrchards", report.inOrchards}, {"hedges", report.hedges}, {"shrubs", report.shrubs},
            {"spacingM", report.spacingM}};
}

nlohmann::ordered_json rowOf(const worldmaking::MadeUpReport& report)
{
    return {{"areaKm2", report.areaKm2},     {"settlements", report.settlements},
            {"unreached", report.unreached}, {"farms", report.farms},
            {"houses", report.houses},       {"fields", report.fields},
            {"hedges", report.hedges},       {"woods", report.woods},
            {"lakes", report.lakes},         {"bridges", report.bridges},
            {"roadsKm", report.roadsKm},     {"airfields", report.airfields}};
}

nlohmann::ordered_json rowOf(const worldmaking::WaterReport& report)
{
    return {{"lakes", report.lakes},
            {"rivers", report.rivers},
            {"unlevelled", report.unlevelled},
            {"beyondGround", report.beyondGround}};
}

nlohmann::ordered_json rowOf(const worldmaking::AirfieldReport& report)
{
    return {{"runways", report.runways},
            {"steepRunways", report.steepRunways},
            {"taxiways", report.taxiways},
            {"aprons", report.aprons},
            {"beyondGround", report.beyondGround}};
}

nlohmann::ordered_json rowOf(const worldmaking::StructureReport& report)
{
    return {{"walls", report.walls},
            {"fences", report.fences},
            {"powerLines", report.powerLines},
            {"railways", report.railways},
            {"turbines", report.turbines},
            {"windsocks", report.windsocks},
            {"footbridges", report.footbridges},
            {"cut", report.cut},
            {"beyondGround", report.beyondGround}};
}

} // namespace worldtool
