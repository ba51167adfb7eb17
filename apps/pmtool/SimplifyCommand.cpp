// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>

#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/order/FaceOrder.h>

#include "pmtool/LevelMaker.h"
#include "pmtool/ModelFiles.h"
#include "pmtool/Models.h"
#include "pmtool/QuadricOptions.h"
#include "terminal/CommandLine.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
using Json = nlohmann::ordered_json;

const std::map<std::string, SimplifyMethod> kMethods = {{"edges", SimplifyMethod::edges},
                                                        {"clusters", SimplifyMethod::clusters},
                                                        {"images", SimplifyMethod::images},
                                                        {"removal", SimplifyMethod::removal}};

struct SimplifyRequest
{
    ModelRequest models;
    SimplifyMethod method = SimplifyMethod::edges;
    core::SimplifySettings settings;
    std::vector<double> targetsPercent;
    std::vector<double> tolerances; ///< units of the model
    std::vector<double> farther;    ///< times the distance at which all faces are drawn
    RemovalRequest removal;
    double envelopePercent = 0.0; ///< of the diagonal
    double joinPercent = 0.0;     ///< the same
    double speckSize = 0.0;       ///< units of the model
    std::filesystem::path outputFolder;
    std::string format = "osgb";
};

std::string shortest(double value)
{
    std::ostringstream text;
    text << value;
    return text.str();
}

std::vector<LevelWish> wishesOf(const SimplifyRequest& request, std::size_t facesBefore)
{
    std::vector<LevelWish> wishes;
    for (const double percent : request.targetsPercent)
    {
        const double faces = static_cast<double>(facesBefore) * percent / 100.0;
        wishes.push_back({shortest(percent) + "pc", static_cast<std::size_t>(std::llround(faces))});
    }
    for (const double tolerance : request.tolerances)
        wishes.push_back({shortest(tolerance) + "m", std::nullopt, tolerance});
    for (const double farther : request.farther)
        wishes.push_back({shortest(farther) + "x", std::nullopt, 0.0, farther});
    return wishes;
}

std::unique_ptr<LevelMaker> makerOf(const SimplifyRequest& request, const ImportedModel& model)
{
    if (request.method == SimplifyMethod::clusters) return clusterLevels(model.mesh, request.speckSize);
    if (request.method == SimplifyMethod::removal)
        return removalLevels(model, request.removal, request.speckSize);
    core::SimplifySettings settings = request.settings;
    const double diagonal = core::diagonalOf(model.mesh);
    settings.envelope = request.envelopePercent / 100.0 * diagonal;
    settings.joinDistance = request.joinPercent / 100.0 * diagonal;
    return sequenceLevels(model, settings, request.method == SimplifyMethod::images, request.speckSize);
}

foundation::Outcome writeLevel(const ImportedModel& model, core::Mesh level,
                               const std::filesystem::path& file)
{
    core::orderFaces(level, core::FaceOrder::library);
    return writeModel({std::move(level), model.states, model.remainder, {}}, file);
}

void printModel(const Json& row)
{
    std::cout << row["model"].get<std::string>() << ": " << row["triangles"] << " triangles";
    if (row.contains("least")) std::cout << ", at least " << row["least"] << ", " << row["ms"] << " ms";
    std::cout << '\n';
}

std::string distanceText(const Json& distance)
{
    return distance.is_null() ? "any distance (no surface is left)" : shortest(distance.get<double>());
}

void printLevel(const Json& level)
{
    std::cout << "  " << std::setw(8) << level["level"].get<std::string>() << std::setw(9)
              << level["triangles"].get<std::size_t>() << " triangles, off by at most "
              << distanceText(level["errorMax"]) << ", rms " << distanceText(level["errorRms"]);
    if (level.contains("cellSize"))
        std::cout << ", cells of " << level["cellSize"].get<double>();
    else
        std::cout << ", texture by " << level["texCoord"].get<double>();
    if (level.contains("specksVanished")) std::cout << ", specks vanished: " << level["specksVanished"];
    if (level.contains("ms")) std::cout << ", " << level["ms"].get<double>() << " ms";
    std::cout << '\n';
}

foundation::Result<Json> simplifyFile(const SimplifyRequest& request, OutputNames& names,
                                      const std::string& file)
{
    auto model = readClean(file, request.models.limits);
    if (!model) return model.error();
    const ImportedModel& imported = model->read.imported;
    const std::size_t facesBefore = imported.mesh.faces.size();
    const auto maker = makerOf(request, imported);
    Json row{{"model", file}, {"triangles", facesBefore}};
    row.update(maker->summary());
    addLosses(row, model->read);
    row["levels"] = Json::array();
    printModel(row);
    printLosses(row);
    const std::string name = names.nameFor(file);
    for (const LevelWish& wish : wishesOf(request, facesBefore))
    {
        auto level = maker->make(wish);
        if (!level)
            return foundation::Error{file + ", level " + wish.name, level.error().what, level.error().remedy};
        if (!request.outputFolder.empty())
        {
            const std::string written = name + '.' + wish.name + '.' + request.format;
            if (const auto done =
                    writeLevel(imported, std::move(level->mesh), request.outputFolder / written);
                !done)
                return done.error();
            level->row["file"] = written;
        }
        printLevel(level->row);
        row["levels"].push_back(std::move(level->row));
    }
    return row;
}

foundation::Result<terminal::Report> simplifyModels(SimplifyRequest request)
{
    if (request.targetsPercent.empty() && request.tolerances.empty() && request.farther.empty())
        request.targetsPercent = {25, 5, 1};
    if (!request.outputFolder.empty())
        if (const auto made = makeFolder(request.outputFolder); !made) return made.error();
    OutputNames names;
    return forEachModel(request.models.files,
                        [&](const std::string& file) { return simplifyFile(request, names, file); });
}

/// The options that say which levels are made, and what counts as their distance.
void addLevels(CLI::App& command, SimplifyRequest& request)
{
    command.add_option("--targets", request.targetsPercent, "triangles to keep, per cent (25,5,1)")
        ->delimiter(',')
        ->check(terminal::between(0.001, 100.0));
    command
        .add_option("--tolerances", request.tolerances,
                    "levels by their largest measured distance from the original, in units of the model")
        ->delimiter(',')
        ->check(terminal::between(0.0, 1e9));
    command
        .add_option("--specks", request.speckSize,
                    "parts up to this size may vanish and do not count as distance, in units of the model "
                    "(0: all count)")
        ->check(terminal::between(0.0, 1e9));
    command
        .add_option("--farther", request.farther,
                    "levels for a distance of so many times the one at which all triangles are drawn")
        ->delimiter(',')
        ->check(terminal::between(1.0, 1e6));
}

/// The options that say how edges collapse.
void addCollapses(CLI::App& command, SimplifyRequest& request)
{
    const std::map<std::string, core::Placement> placements = {{"subset", core::Placement::subset},
                                                               {"optimal", core::Placement::optimal},
                                                               {"quality", core::Placement::quality}};
    command
        .add_option("--placement", request.settings.placement,
                    "positions of vertices: subset, optimal (default), quality")
        ->transform(terminal::named(placements));
    addQuadrics(command, request.settings.quadrics);
    command
        .add_option("--envelope", request.envelopePercent,
                    "largest distance from the original, per cent of the diagonal (0: no limit)")
        ->check(terminal::between(0.0, 100.0));
    command
        .add_option("--join", request.joinPercent,
                    "parts this near to one another may join, per cent of the diagonal (0: none)")
        ->check(terminal::between(0.0, 100.0));
    command
        .add_flag("--join-within", request.settings.joinWithinParts,
                  "with --join: so may positions of one part that are on two sides of a gap")
        ->needs("--join");
    command.add_flag("!--shape-only", request.settings.keepSeams, "let textures, normals and materials go");
    command.add_flag("!--lopsided", request.settings.keepSymmetry, "do not keep symmetric models symmetric");
    command.add_flag("!--thin-leaves", request.settings.growLeaves,
                     "let leaf cards vanish without others growing");
}

/// Refuses options that a method would ignore.
void refuseOptions(const CLI::App& command, const SimplifyRequest& request)
{
    std::vector<const char*> refused;
    if (request.method == SimplifyMethod::clusters)
        refused = {"--placement",  "--quadrics", "--envelope",    "--join",   "--join-within",
                   "--shape-only", "--lopsided", "--thin-leaves", "--farther"};
    if (request.method == SimplifyMethod::images) refused = {"--tolerances", "--envelope", "--farther"};
    if (request.method == SimplifyMethod::removal)
        refused = {"--placement",   "--quadrics",   "--envelope", "--join",
                   "--join-within", "--shape-only", "--lopsided", "--thin-leaves"};
    else
        refused.insert(refused.end(), {"--support", "--support-depth"});
    for (const char* option : refused)
        if (command.count(option) > 0)
            throw CLI::ValidationError(option, "has no meaning with this --method");
}

} // namespace

void addSimplify(CLI::App& app, Chosen& chosen)
{
    const auto request = std::make_shared<SimplifyRequest>();
    request->settings.placement = core::Placement::optimal;
    CLI::App* command = app.add_subcommand("simplify", "make levels of each model with fewer triangles");
    addModelOptions(*command, request->models, chosen.jsonFile);
    command
        ->add_option("--method", request->method,
                     "edges: collapses by error (default); clusters: one vertex for each cube of a grid; "
                     "images: the last collapses chosen by images; removal: vertices one by one")
        ->transform(terminal::named(kMethods));
    addLevels(*command, *request);
    addRemovalOptions(*command, request->removal);
    addCollapses(*command, *request);
    command->add_option("--output", request->outputFolder, "folder for the levels, NAME.LEVEL.FORMAT");
    command->add_option("--format", request->format, "format of the levels (osgb)")
        ->check(CLI::IsMember({"osgb", "osgt", "ive"}));
    command->callback(
        [request, command, &chosen]
        {
            refuseOptions(*command, *request);
            chosen.work = [request] { return simplifyModels(*request); };
        });
}

} // namespace pmtool
