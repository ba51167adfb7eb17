// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <map>
#include <memory>

#include <foundation/WholeFile.h>

#include "pmtool/ModelFiles.h"
#include "pmtool/Models.h"
#include "pmtool/Timing.h"
#include "pmtool/polygons/CutPolygons.h"
#include "pmtool/polygons/ReadPolygons.h"
#include "terminal/CommandLine.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
using Json = nlohmann::ordered_json;

const std::map<std::string, core::InsideRule> kInsides{{"odd", core::InsideRule::odd},
                                                       {"nonzero", core::InsideRule::nonZero},
                                                       {"positive", core::InsideRule::positive}};

const std::map<std::string, core::ProjectionRule> kProjections{
    {"automatic", core::ProjectionRule::automatic},
    {"area", core::ProjectionRule::largestArea},
    {"normal", core::ProjectionRule::averageNormal}};

struct TessellateRequest
{
    std::vector<std::string> files;
    CutSettings cut;
    std::filesystem::path outputFolder;
};

Json rowOf(const std::string& file, const CutMesh& mesh, const CutSettings& settings)
{
    const CutCounts& counts = mesh.counts;
    Json row{{"model", file},
             {"polygons", counts.polygons},
             {"corners", counts.corners},
             {"holes", counts.holes},
             {settings.isConvex ? "pieces" : "triangles", mesh.faces.size()},
             {"vertices", mesh.positions.size()},
             {"inserted", counts.inserted}};
    if (settings.isConvex)
        row["provedLeast"] = counts.leastPieces;
    else
        row.update(Json{{"crossings", counts.crossings},
                        {"unusedCorners", counts.unusedCorners},
                        {"bridges", counts.bridges}});
    if (settings.warpTolerance > 0.0)
        row.update(Json{{"grids", counts.grids}, {"refusedGrids", counts.refusedGrids}});
    return row;
}

void printCut(const Json& row)
{
    std::cout << row["model"].get<std::string>() << '\n';
    for (const auto& [key, value] : row.items())
        if (key != "model") std::cout << "  " << key << ": " << value << '\n';
}

foundation::Result<Json> tessellateFile(const TessellateRequest& request, OutputNames& names,
                                        const std::string& file)
{
    const auto set = readPolygons(file);
    if (!set) return set.error();
    if (set->polygons.empty())
        return foundation::Error{file, "has no polygons", "give faces of .obj, or Polygons of GeoJSON"};
    foundation::Result<CutMesh> mesh = CutMesh();
    const double ms = millisecondsOf([&] { mesh = cutPolygons(*set, request.cut, file); });
    if (!mesh) return mesh.error();
    Json row = rowOf(file, *mesh, request.cut);
    row["ms"] = ms;
    if (!request.outputFolder.empty())
    {
        const std::filesystem::path target = request.outputFolder / (names.nameFor(file) + ".obj");
        if (const auto done = foundation::writeWholeFile(target, objTextOf(*mesh)); !done)
            return done.error();
        row["output"] = target.string();
    }
    printCut(row);
    return row;
}

foundation::Result<terminal::Report> tessellateFiles(const TessellateRequest& request)
{
    if (!request.outputFolder.empty())
        if (const auto made = makeFolder(request.outputFolder); !made) return made.error();
    OutputNames names;
    return forEachModel(request.files,
                        [&](const std::string& file) { return tessellateFile(request, names, file); });
}

} // namespace

void addTessellate(CLI::App& app, Chosen& chosen)
{
    const auto request = std::make_shared<TessellateRequest>();
    CLI::App* command = app.add_subcommand(
        "tessellate", "cut polygons, with holes and crossings, into triangles or convex pieces");
    command->add_option("FILE", request->files, "faces of .obj; Polygons of .geojson or .json")->required();
    addJsonOption(*command, chosen.jsonFile);
    CutSettings& cut = request->cut;
    CLI::Option* convex = command->add_flag("--convex", cut.isConvex, "convex pieces instead of triangles");
    command
        ->add_flag(
            "--quick", [&cut](std::int64_t) { cut.convexMethod = core::ConvexMethod::quick; },
            "unite triangles to convex pieces, instead of searching for the least number of pieces")
        ->needs(convex);
    command
        ->add_option("--uniform", cut.longestEdge,
                     "halve edges longer than this, in units of the file (0: none)")
        ->check(terminal::between(0.0, 1e9))
        ->excludes(convex);
    command
        ->add_option("--warped", cut.warpTolerance,
                     "cut textured quads into grids that keep the texture this near to the bilinear map, in "
                     "widths of the "
                     "texture (0: none)")
        ->check(terminal::between(0.0, 1.0))
        ->excludes(convex);
    command
        ->add_option("--inside", cut.outline.inside,
                     "what belongs to a polygon, by how often its contours run around it: odd (default), "
                     "nonzero, positive")
        ->transform(terminal::named(kInsides));
    command
        ->add_option("--projection", cut.outline.projection,
                     "into the plane: automatic (default), area: along the axis of the largest area, normal: "
                     "along the "
                     "average normal")
        ->transform(terminal::named(kProjections));
    command->add_option("--output", request->outputFolder, "folder for the result, NAME.obj");
    command->callback([request, &chosen] { chosen.work = [request] { return tessellateFiles(*request); }; });
}

} // namespace pmtool
