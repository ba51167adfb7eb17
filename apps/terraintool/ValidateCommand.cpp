// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include <viewlod/Sight.h>

#include <osgTerrainROAM/core/LoadTerrain.h>
#include <osgTerrainROAM/core/method/PrepareTerrain.h>

#include "scenery/roads/LayRoads.h"
#include "simulation/parser/ParseScenario.h"
#include "terminal/Progress.h"
#include "terraintool/Commands.h"
#include "terraintool/FlightFindings.h"
#include "terraintool/FlightViews.h"
#include "terraintool/mt/MtRequest.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;

/// `viewMarginDeg`: absent where the mesh is refined all around.
void checkFrame(TerrainMesh& mesh, const viewlod::ViewState& view, const viewlod::Budget& budget,
                std::optional<double> viewMarginDeg, FlightFindings& flight)
{
    viewlod::Sight sight;
    if (viewMarginDeg) sight.add(view, glm::radians(*viewMarginDeg));
    mesh.setSight(sight);
    const RefineResult result = mesh.refine(view, budget);
    flight.add(checkDrawnMesh(mesh.tile(), mesh.drawn(), &view), result, budget);
}

/// Reads the scenario of a .xosc file; nothing for any other file, which is a terrain.
foundation::Result<std::optional<simulation::Scenario>> scenarioOf(const std::filesystem::path& file)
{
    if (file.extension() != ".xosc") return std::optional<simulation::Scenario>();
    auto parsed = simulation::readScenario(file);
    if (!parsed) return parsed.error();
    return std::optional(std::move(parsed->scenario));
}

/// Returns the terrain of a scenario; any other file is a terrain itself.
foundation::Result<std::filesystem::path> terrainOf(const std::optional<simulation::Scenario>& scenario,
                                                    const std::filesystem::path& file)
{
    if (!scenario) return file;
    if (!scenario->roadNetwork.sceneGraphFile.empty())
        return file.parent_path() / scenario->roadNetwork.sceneGraphFile;
    return foundation::Error{file.string(), "RoadNetwork names no SceneGraphFile", "add one"};
}

/// Loads a terrain and cuts it to the roads that it names.
foundation::Result<std::shared_ptr<const RoamTile>> tileOf(const RoamFile& description,
                                                           const Request& request)
{
    if (!description.roads.empty() && request.patchExponent != 0)
        return foundation::Error{description.roads.string(), "ground with roads has no patches",
                                 "leave out --patch-exponent"};
    const auto loaded = scenery::loadRoadTile(description);
    if (!loaded) return loaded.error();
    return std::shared_ptr<const RoamTile>(loaded->tile);
}

foundation::Result<FlightFindings> fly(const Request& request, const std::string& file,
                                       nlohmann::ordered_json& row)
{
    const auto scenario = scenarioOf(file);
    if (!scenario) return scenario.error();
    const auto terrain = terrainOf(*scenario, file);
    if (!terrain) return terrain.error();
    const auto description = describeTerrain(*terrain, request.import);
    if (!description) return description.error();
    const auto tile = tileOf(*description, request);
    if (!tile) return tile.error();
    const PlacedTile& placed = (*tile)->tile;
    row["samples"] = placed.samples().table().size();
    row["voids"] = placed.field().voids.count;
    const auto views = *scenario ? scenarioViews(**scenario, file, placed, request.frames)
                                 : tourViews(placed, request.frames);
    if (!views) return views.error();

    const Method method = request.method.value_or(description->method);
    const auto marginDeg = request.viewMarginDeg ? request.viewMarginDeg : description->viewMarginDeg;
    const auto prepared = prepareTerrain(*tile,
                                         {.method = method,
                                          .patchExponent = request.patchExponent,
                                          .morphing = request.morphing,
                                          .inSight = marginDeg.has_value()},
                                         file);
    if (!prepared) return prepared.error();
    const std::unique_ptr<TerrainMesh> mesh = (*prepared)->newMesh();
    mesh->setMorphing(request.morphing);
    FlightFindings flight;
    terminal::Progress progress(file, views->size());
    for (const viewlod::ViewState& view : *views)
    {
        checkFrame(*mesh, view,
                   {.errorTolerancePx = request.tolerancePx, .maxTriangles = request.maxTriangles}, marginDeg,
                   flight);
        progress.advance();
    }
    return flight;
}

} // namespace

foundation::Result<Report> validate(const Request& request)
{
    if (const auto sound = checkHeads(request); !sound) return sound.error();
    Report report;
    for (const std::string& file : request.files)
    {
        if (std::filesystem::path(file).extension() == ".mt")
        {
            validateMt(file, request.frames, report);
            continue;
        }
        nlohmann::ordered_json row;
        row["file"] = file;
        const auto flight = fly(request, file, row);
        if (!flight) return flight.error();
        row["frames"] = flight->frames;
        row["tJunctions"] = flight->tJunctions;
        row["cracks"] = flight->cracks;
        row["maxErrorPx"] = flight->maxErrorPx;
        row["tolerancePx"] = flight->tolerancePx;
        row["ceilingExceeded"] = flight->ceilingExceeded;
        report.sound = report.sound && flight->isSound();
        std::cout << (flight->isSound() ? "sound  " : "BROKEN ") << file << ": " << flight->text() << '\n';
        report.json["files"].push_back(std::move(row));
    }
    return report;
}

} // namespace terraintool
