// SPDX-License-Identifier: Apache-2.0
// The last stages of MadeUpLand: what is made up as shapes of a map.
#include <cstdio>
#include <string>

#include "worldmaking/madeup/Bridges.h"
#include "worldmaking/madeup/MadeUpLand.h"
#include "worldmaking/madeup/OpenLand.h"

namespace worldmaking
{

namespace
{

constexpr double kRiverKm2 = 12.0;

} // namespace

void MadeUpLand::emitStreets()
{
    const auto knots = _web.knots();
    std::vector<Stream> bridged;
    for (const Stream& stream : _streams)
        if (stream.areaKm2 > kBridgedKm2) bridged.push_back(stream);
    for (const MadeWay& way : _web.ways())
        for (const WayPart& part : bridgedParts(way, bridged, _ground, knots))
        {
            Tags tags{{"highway", std::string(way.kind)}};
            if (way.settlement >= 0) tags["sidewalk"] = "both";
            if (part.isBridge) tags["bridge"] = "yes", tags["layer"] = "1";
            report.bridges += part.isBridge;
            if (part.isBridge)
                places.emplace_back("bridge", 0.5 * (part.points.front() + part.points.back()));
            for (std::size_t i = 0; i + 1 < part.points.size(); ++i)
                report.roadsKm += 0.001 * glm::distance(part.points[i], part.points[i + 1]);
            shapes.push_back(lineShape(part.points, std::move(tags)));
        }
}

void MadeUpLand::emitLand()
{
    for (const PlanRings& lake : _lakes.all())
        shapes.push_back(areaShape(lake, {{"natural", "water"}, {"water", "lake"}}));
    for (const Stream& stream : _streams)
    {
        char width[16];
        std::snprintf(width, sizeof width, "%.1f", stream.widthM());
        shapes.push_back(
            lineShape(stream.points,
                      {{"waterway", stream.areaKm2 > kRiverKm2 ? "river" : "stream"}, {"width", width}}));
    }
    for (const Settlement& settlement : _settlements)
    {
        shapes.push_back(pointShape(settlement.middle, {{"place", std::string(nameOf(settlement.kind))}}));
    }
    if (airfield)
        for (MadeShape& shape : airfield->shapes())
            shapes.push_back(std::move(shape));
    if (_settings.aridity > 0.5) return; // the desert's own ground
    // All other low ground is grass, up to where it is bare: then no wood is seen where no tree stands.
    const OpenLand open = openLandOn(_ground, _treeLineM, _settings.seed);
    for (const PlanRings& area : open.grass)
        shapes.push_back(areaShape(area, {{"natural", "grassland"}}));
    for (const PlanRings& area : open.rock)
        shapes.push_back(areaShape(area, {{"natural", "bare_rock"}}));
}

} // namespace worldmaking
