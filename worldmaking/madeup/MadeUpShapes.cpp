// SPDX-License-Identifier: Apache-2.0
// The last stages of MadeUpLand: what is made up as shapes of a map.
#include <cstdio>
#include <string>

#include "worldmaking/madeup/Bridges.h"
#include "worldmaking/madeup/Contours.h"
#include "worldmaking/madeup/MadeUpLand.h"

namespace worldmaking
{

namespace
{

constexpr double kRiverKm2 = 12.0;
constexpr double kGrassAboveM = 100.0; ///< the tree line

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
    // All other low ground is grass, up to the trees' line: then no wood is seen where no tree stands.
    std::vector<float> lows;
    for (int row = 0; row < _ground.rows(); ++row)
        for (int column = 0; column < _ground.columns(); ++column)
        {
            const double height = _ground.heightAt(column, row);
            const bool isLow =
                _ground.hasGround(column, row) && (!_ground.hasSea() || height > GroundGrid::kShoreM);
            lows.push_back(isLow ? static_cast<float>(_treeLineM + kGrassAboveM - height) : -1.0F);
        }
    if (_settings.aridity > 0.5) return; // the desert's own ground
    const double cell = _ground.cellM();
    const MapBox box{_ground.box().low - 0.5 * cell, _ground.box().high + 0.5 * cell};
    for (PlanRings& area : areasAbove(lows, _ground.columns(), box, cell, 0.0, 1e5))
        shapes.push_back(areaShape(std::move(area), {{"natural", "grassland"}}));
}

} // namespace worldmaking
