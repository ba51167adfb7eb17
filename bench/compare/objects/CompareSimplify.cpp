// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <memory>

#include "compare/objects/CheckerCoordinates.h"
#include "compare/objects/Commands.h"
#include "compare/objects/SimplifyRow.h"
#include "compare/objects/SimplifyTool.h"
#include "pmtool/ModelFiles.h"
#include "pmtool/Models.h"
#include "terminal/CommandLine.h"
#include "terminal/Terminal.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
using Json = nlohmann::ordered_json;

struct CompareRequest
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

foundation::Outcome compareTool(const SimplifySubject& subject, const SimplifyTool& tool, bool seams,
                                const CompareRequest& request, Json& results)
{
    const auto levels = tool.run({subject.mesh, subject.shape, seams, subject.targets, request.seconds});
    for (std::size_t i = 0; i < subject.targets.size(); ++i)
    {
        Json row{{"tool", tool.name}, {"seams", seams}, {"targetPercent", subject.percents[i]}};
        if (levels)
            addMeasures(row, subject, (*levels)[i], subject.targets[i]);
        else
            row["refused"] = levels.error().message();
        if (levels && !request.dumpFolder.empty())
            if (const auto done = dump((*levels)[i].mesh, request.dumpFolder, dumpName(subject, row), row);
                !done)
                return done.error();
        printRow(row);
        results.push_back(std::move(row));
    }
    return foundation::success();
}

foundation::Result<Json> compareModel(const std::string& file, const CompareRequest& request,
                                      OutputNames& names)
{
    auto model = readClean(file, request.models.limits);
    if (!model) return model.error();
    core::Mesh& mesh = model->read.imported.mesh;
    if (request.checker) addCheckerCoordinates(mesh);
    const SimplifySubject subject(names.nameFor(file), std::move(mesh), request.targetPercents);
    Json row{{"model", file},
             {"triangles", subject.mesh.faces.size()},
             {"trianglesRead", model->trianglesRead},
             {"results", Json::array()}};
    printHeading(file, subject);
    if (!request.dumpFolder.empty())
        if (const auto done = dump(subject.mesh, request.dumpFolder, subject.name + ".original", row); !done)
            return done.error();
    for (const SimplifyTool& tool : request.tools)
        for (const bool seams : {true, false})
        {
            if (request.seams == (seams ? "no" : "yes") || (seams && !tool.keepsSeams)) continue;
            if (const auto done = compareTool(subject, tool, seams, request, row["results"]); !done)
                return done.error();
        }
    return row;
}

foundation::Result<terminal::Report> compareSimplifiers(const CompareRequest& request)
{
    if (!request.dumpFolder.empty())
        if (const auto made = makeFolder(request.dumpFolder); !made) return made.error();
    OutputNames names;
    return forEachModel(
        request.models.files, [&](const std::string& file) { return compareModel(file, request, names); },
        kComparer);
}

/// Names of tools are parts of file names, too.
bool isName(const std::string& name)
{
    return !name.empty() &&
           std::all_of(name.begin(), name.end(),
                       [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_'; });
}

/// Returns all tools, peers last, or the requested ones in their order. Throws where the command line names
/// no tool.
std::vector<SimplifyTool> chosenTools(const CompareRequest& request)
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

void addCompareSimplify(CLI::App& app, Chosen& chosen)
{
    const auto request = std::make_shared<CompareRequest>();
    CLI::App* sub = app.add_subcommand(
        "simplify", "ways to simplify, by the distance between surfaces at several counts of triangles");
    addModelOptions(*sub, request->models, chosen.jsonFile);
    sub->add_option("--dump", request->dumpFolder,
                    "write the original and every level to this folder, as plain .obj");
    sub->add_option("--tools", request->toolNames, "only these, with commas between")->delimiter(',');
    sub->add_option("--targets", request->targetPercents, "triangles to keep, per cent (50,25,10,5,1)")
        ->delimiter(',')
        ->check(terminal::between(0.001, 100.0));
    sub->add_option("--seams", request->seams,
                    "attributes and materials are kept: yes, no (only the shape counts), both (both)")
        ->check(CLI::IsMember({"yes", "no", "both"}));
    sub->add_option("--peer", request->peers,
                    "NAME=PROGRAM: another simplifier, called PROGRAM IN.obj FOLDER COUNT…");
    sub->add_option("--tool-seconds", request->seconds,
                    "most time for a level of osgUtil, or for all levels of a peer, in seconds (60)")
        ->check(terminal::between(0.01, 86400.0));
    sub->add_flag("--checker", request->checker,
                  "put generated texture coordinates with seams on every model");
    sub->callback(
        [&chosen, request]
        {
            request->tools = chosenTools(*request);
            chosen.work = [request] { return compareSimplifiers(*request); };
        });
}

} // namespace pmtool
