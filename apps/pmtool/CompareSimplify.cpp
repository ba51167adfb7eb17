// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/simplify/SimplificationError.h>

#include "pmtool/CheckerCoordinates.h"
#include "pmtool/ModelFiles.h"
#include "pmtool/Models.h"
#include "pmtool/SimplifyTool.h"
#include "terminal/Terminal.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
using Json = nlohmann::ordered_json;

struct Request
{
    ModelRequest models;
    std::filesystem::path dumpFolder;
    std::vector<std::string> toolNames, peers; ///< peers: NAME=PROGRAM
    std::vector<double> targetPercents{50.0, 25.0, 10.0, 5.0, 1.0};
    std::string seams = "both";
    bool checker = false;
    double seconds = 60.0;
    std::vector<SimplifyTool> tools; ///< those that were chosen
};

/// A model, and all that is the same for every tool.
struct Subject
{
    std::string name; ///< of its dumps
    core::Mesh mesh, shape;
    core::SimplificationMeter meter;
    std::vector<double> percents; ///< falling
    std::vector<std::size_t> targets;

    Subject(std::string subjectName, core::Mesh clean, std::vector<double> targetPercents)
        : name(std::move(subjectName)),
          mesh(std::move(clean)),
          shape(shapeOf(mesh)),
          meter(mesh),
          percents(std::move(targetPercents))
    {
        std::sort(percents.rbegin(), percents.rend());
        for (const double percent : percents)
            targets.push_back(static_cast<std::size_t>(
                std::max(1.0, std::round(percent / 100.0 * static_cast<double>(mesh.faces.size())))));
    }
};

/// Within max(1 %, 4 triangles) a count is reached.
bool isStuck(std::size_t reached, std::size_t target)
{
    return reached > target + std::max<std::size_t>(4, target / 100);
}

Json rowOf(const Subject& subject, std::size_t i, const SimplifyTool& tool, bool seams)
{
    return {{"tool", tool.name}, {"seams", seams}, {"targetPercent", subject.percents[i]}};
}

Json measured(const Subject& subject, const SimplifiedLevel& level, std::size_t i, Json row)
{
    const core::SimplificationError error = subject.meter.measure(level.mesh);
    row["trianglesReached"] = level.mesh.faces.size();
    row["meanErrorPercent"] = error.meanPercent;
    row["maxErrorPercent"] = error.maxPercent;
    row["boxExcessPercent"] = error.boxExcessPercent;
    row["uvDriftTexels"] = error.drift ? Json(error.drift->ofNinetyNine) : Json();
    row["ms"] = level.ms;
    row["trianglesWanted"] = subject.targets[i];
    row["stuck"] = isStuck(level.mesh.faces.size(), subject.targets[i]);
    if (row["seams"]) row["materialsMissing"] = core::countMissingMaterials(subject.mesh, level.mesh);
    if (error.drift)
        row["uvDriftMeanTexels"] = error.drift->mean, row["uvDriftMaxTexels"] = error.drift->largest;
    if (!level.isInTime) row["timedOut"] = true;
    return row;
}

void print(const Json& row)
{
    std::cout << "  " << std::left << std::setw(14) << row["tool"].get<std::string>() << std::setw(6)
              << (row["seams"] ? "seams" : "shape") << std::right << std::defaultfloat << std::setprecision(3)
              << std::setw(6) << row["targetPercent"].get<double>();
    if (row.contains("refused"))
    {
        std::cout << "  " << row["refused"].get<std::string>() << '\n';
        return;
    }
    std::cout << std::setw(9) << row["trianglesReached"].get<std::size_t>() << std::fixed
              << std::setprecision(4) << std::setw(10) << row["meanErrorPercent"].get<double>()
              << std::setw(10) << row["maxErrorPercent"].get<double>() << std::setw(10)
              << row["boxExcessPercent"].get<double>() << std::setprecision(2) << std::setw(9);
    if (row["uvDriftTexels"].is_null())
        std::cout << '-';
    else
        std::cout << row["uvDriftTexels"].get<double>();
    std::cout << std::setprecision(1) << std::setw(10) << row["ms"].get<double>()
              << (row["stuck"] ? "  stuck" : "") << (row.contains("timedOut") ? "  out of time" : "") << '\n';
}

/// "forklift.subset.seams.5.obj"
std::string dumpName(const Subject& subject, const Json& row)
{
    std::ostringstream name;
    name << subject.name << '.' << row["tool"].get<std::string>() << '.' << (row["seams"] ? "seams" : "shape")
         << '.' << row["targetPercent"].get<double>() << ".obj";
    return name.str();
}

viewlod::Outcome compareTool(const Subject& subject, const SimplifyTool& tool, bool seams,
                             const Request& request, Json& results)
{
    const auto levels = tool.run({subject.mesh, subject.shape, seams, subject.targets, request.seconds});
    for (std::size_t i = 0; i < subject.targets.size(); ++i)
    {
        Json row = rowOf(subject, i, tool, seams);
        if (levels)
            row = measured(subject, (*levels)[i], i, std::move(row));
        else
            row["refused"] = levels.error().message();
        if (levels && !request.dumpFolder.empty())
        {
            const std::string file = dumpName(subject, row);
            if (const auto written = writePlain((*levels)[i].mesh, request.dumpFolder / file); !written)
                return written.error();
            row["dump"] = file;
        }
        print(row);
        results.push_back(std::move(row));
    }
    return viewlod::success();
}

viewlod::Result<Json> compareModel(const std::string& file, const Request& request, OutputNames& names)
{
    auto model = read(file, request.models.limits);
    if (!model) return model.error();
    core::Mesh& mesh = model->imported.mesh;
    const std::size_t trianglesRead = mesh.faces.size();
    core::consolidate(mesh);
    if (mesh.faces.empty())
        return viewlod::Error{file, "has no triangles that can be simplified", "give a model with surfaces"};
    if (request.checker) addCheckerCoordinates(mesh);
    const Subject subject(names.nameFor(file), std::move(mesh), request.targetPercents);
    Json row{{"model", file},
             {"triangles", subject.mesh.faces.size()},
             {"trianglesRead", trianglesRead},
             {"results", Json::array()}};
    std::cout << file << ": " << subject.mesh.faces.size()
              << " triangles\n  tool          keeps      % triangles"
              << "      mean       max  box out    drift        ms\n";
    if (!request.dumpFolder.empty())
    {
        row["dump"] = subject.name + ".original.obj";
        if (const auto written =
                writePlain(subject.mesh, request.dumpFolder / row["dump"].get<std::string>());
            !written)
            return written.error();
    }
    for (const SimplifyTool& tool : request.tools)
        for (const bool seams : {true, false})
        {
            if (request.seams == (seams ? "no" : "yes") || (seams && !tool.keepsSeams)) continue;
            if (const auto done = compareTool(subject, tool, seams, request, row["results"]); !done)
                return done.error();
        }
    return row;
}

viewlod::Result<terminal::Report> compareModels(const Request& request)
{
    if (!request.dumpFolder.empty())
        if (const auto made = makeFolder(request.dumpFolder); !made) return made.error();
    OutputNames names;
    return forEachModel(request.models,
                        [&](const std::string& file) { return compareModel(file, request, names); });
}

/// Names of tools are parts of file names, too.
bool isName(const std::string& name)
{
    return !name.empty() &&
           std::all_of(name.begin(), name.end(),
                       [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_'; });
}

/// All tools, peers last, or those asked for in the order asked for. Throws: what the command line says makes no sense.
std::vector<SimplifyTool> chosenTools(const Request& request)
{
    std::vector<SimplifyTool> all = simplifyTools();
    for (const std::string& peer : request.peers)
    {
        const std::size_t equals = peer.find('=');
        const std::string name = peer.substr(0, equals);
        if (equals == std::string::npos || equals + 1 == peer.size() || !isName(name))
            throw CLI::ValidationError("--peer",
                                       "'" + peer + "' is not NAME=PROGRAM, of letters, digits, - and _");
        all.push_back(peerTool(name, peer.substr(equals + 1)));
    }
    if (request.toolNames.empty()) return all;
    std::vector<SimplifyTool> chosen;
    for (const std::string& name : request.toolNames)
    {
        const auto tool =
            std::find_if(all.begin(), all.end(), [&](const SimplifyTool& t) { return t.name == name; });
        if (tool == all.end())
        {
            std::string names;
            for (const SimplifyTool& t : all)
                names += (names.empty() ? "" : ", ") + t.name;
            throw CLI::ValidationError("--tools", "'" + name + "' is none of " + names);
        }
        chosen.push_back(*tool);
    }
    return chosen;
}

} // namespace

void addCompareSimplify(CLI::App& compare, Chosen& chosen)
{
    const auto request = std::make_shared<Request>();
    CLI::App* sub = compare.add_subcommand(
        "simplify", "ways to simplify, by the distance between surfaces at several counts of triangles");
    addModelOptions(*sub, request->models, chosen.jsonFile);
    sub->add_option("--dump", request->dumpFolder,
                    "write the original and every level to this folder, as plain .obj");
    sub->add_option("--tools", request->toolNames, "these alone, with commas between")->delimiter(',');
    sub->add_option("--targets", request->targetPercents, "of the triangles, in per cent (50,25,10,5,1)")
        ->delimiter(',')
        ->check(terminal::between(0.001, 100.0));
    sub->add_option("--seams", request->seams,
                    "attributes and materials are kept: yes, no (only the shape counts), both (both)")
        ->check(CLI::IsMember({"yes", "no", "both"}));
    sub->add_option("--peer", request->peers,
                    "NAME=PROGRAM: another simplifier, called PROGRAM IN.obj FOLDER COUNT…");
    sub->add_option("--tool-seconds", request->seconds,
                    "most time for a level of osgUtil, or for all of a peer (60)")
        ->check(terminal::between(0.01, 86400.0));
    sub->add_flag("--checker", request->checker,
                  "put generated texture coordinates with seams on every model");
    sub->callback(
        [&chosen, request]
        {
            request->tools = chosenTools(*request);
            chosen.work = [request] { return compareModels(*request); };
        });
}

} // namespace pmtool
