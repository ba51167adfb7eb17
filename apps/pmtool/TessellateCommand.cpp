// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <foundation/WholeFile.h>

#include "pmtool/ModelFiles.h"
#include "pmtool/Models.h"
#include "pmtool/TextureFile.h"
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
    std::filesystem::path textureFile; ///< of quads that are pre-warped
    std::filesystem::path outputFolder;
};

/// Reads the value of `--warped`; returns what is wrong with it.
std::string readWarped(const std::string& how, CutSettings& cut)
{
    cut.warpTolerance = 0.0;
    cut.quadTexture = how == "pre"          ? QuadTexture::preWarped
                      : how == "projective" ? QuadTexture::projective
                                            : QuadTexture::affine;
    if (cut.quadTexture != QuadTexture::affine) return {};
    const auto [end, failed] = std::from_chars(how.data(), how.data() + how.size(), cut.warpTolerance);
    const bool isNumber = failed == std::errc() && end == how.data() + how.size();
    if (isNumber && cut.warpTolerance >= 0.0 && cut.warpTolerance <= 1.0) return {};
    return "'" + how + "' is neither in 0 ... 1 nor pre or projective";
}

/// Refuses settings that do not go together.
void checkWarped(const TessellateRequest& request)
{
    const bool isPre = request.cut.quadTexture == QuadTexture::preWarped;
    if (isPre && request.textureFile.empty())
        throw CLI::ValidationError("--warped pre", "needs the --texture that is to be warped");
    if (!isPre && !request.textureFile.empty())
        throw CLI::ValidationError("--texture", "has a meaning with --warped pre only");
    if (request.cut.quadTexture != QuadTexture::affine && request.cut.longestEdge > 0.0)
        throw CLI::ValidationError("--uniform", "goes with a --warped that is a number only");
}

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
    if (settings.quadTexture != QuadTexture::affine)
        row.update(Json{{"warpedQuads", counts.warpedQuads}, {"refusedQuads", counts.refusedQuads}});
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

/// Writes the faces of a file, and with a pre-warped texture that and the material that shows it.
foundation::Outcome writeCut(const CutMesh& mesh, const std::optional<Texels>& texture,
                             const std::filesystem::path& target)
{
    const auto beside = [&](const char* extension)
    { return std::filesystem::path(target).replace_extension(extension); };
    std::string text = objTextOf(mesh);
    if (texture)
    {
        const std::filesystem::path material = beside(".mtl"), picture = beside(".png");
        text = "mtllib " + material.filename().string() + "\nusemtl warped\n" + text;
        const std::string look = "newmtl warped\nKd 1 1 1\nmap_Kd " + picture.filename().string() + '\n';
        if (auto done = writeTexels(*texture, picture); !done) return done;
        if (auto done = foundation::writeWholeFile(material, look); !done) return done;
    }
    return foundation::writeWholeFile(target, text);
}

/// Warps the texture for the faces of a file, if that was asked for.
foundation::Result<std::optional<Texels>> warpedFor(const CutMesh& mesh, const std::optional<Texels>& texture,
                                                    const std::string& file)
{
    if (!texture) return std::optional<Texels>();
    auto warped = warpTexture(*texture, mesh.texturedFaces);
    if (!warped)
        return foundation::Error{file + ", " + warped.error().place, warped.error().what,
                                 warped.error().remedy};
    return std::optional(*std::move(warped));
}

foundation::Result<Json> tessellateFile(const TessellateRequest& request, OutputNames& names,
                                        const std::optional<Texels>& texture, const std::string& file)
{
    const auto set = readPolygons(file);
    if (!set) return set.error();
    if (set->polygons.empty())
        return foundation::Error{file, "has no polygons", "give faces of .obj, or Polygons of GeoJSON"};
    foundation::Result<CutMesh> mesh = CutMesh();
    const double ms = millisecondsOf([&] { mesh = cutPolygons(*set, request.cut, file); });
    if (!mesh) return mesh.error();
    const auto warped = warpedFor(*mesh, texture, file);
    if (!warped) return warped.error();
    Json row = rowOf(file, *mesh, request.cut);
    row["ms"] = ms;
    if (!request.outputFolder.empty())
    {
        const std::filesystem::path target = request.outputFolder / (names.nameFor(file) + ".obj");
        if (const auto done = writeCut(*mesh, *warped, target); !done) return done.error();
        row["output"] = target.string();
    }
    printCut(row);
    return row;
}

foundation::Result<terminal::Report> tessellateFiles(const TessellateRequest& request)
{
    if (!request.outputFolder.empty())
        if (const auto made = makeFolder(request.outputFolder); !made) return made.error();
    std::optional<Texels> texture;
    if (!request.textureFile.empty())
    {
        auto read = readTexels(request.textureFile);
        if (!read) return read.error();
        texture = *std::move(read);
    }
    OutputNames names;
    return forEachModel(request.files, [&](const std::string& file)
                        { return tessellateFile(request, names, texture, file); });
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
        ->add_option_function<std::string>(
            "--warped",
            [&cut](const std::string& how)
            {
                if (const std::string wrong = readWarped(how, cut); !wrong.empty())
                    throw CLI::ValidationError("--warped", wrong);
            },
            "keep the texture of quads: cut into grids this near to the bilinear map, in widths of the "
            "texture (0: none); pre: warp the texture for two triangles; projective: coordinates u q, v q, q")
        ->excludes(convex);
    command->add_option("--texture", request->textureFile, "with --warped pre: the picture to warp");
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
    command->callback(
        [request, &chosen]
        {
            checkWarped(*request);
            chosen.work = [request] { return tessellateFiles(*request); };
        });
}

} // namespace pmtool
