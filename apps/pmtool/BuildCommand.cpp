// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <map>
#include <memory>

#include <foundation/WholeFile.h>

#include <osgPMObjects/core/progressive/MeasureLevels.h>
#include <osgPMObjects/core/progressive/PmFile.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include <osgPMObjects/MaterialLooks>
#include <osgPMObjects/PmNode>

#include "pmtool/ArrangementOptions.h"
#include "pmtool/Models.h"
#include "pmtool/QuadricOptions.h"
#include "pmtool/RemovalOptions.h"
#include "pmtool/Timing.h"
#include "terminal/CommandLine.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
using Json = nlohmann::ordered_json;

struct BuildRequest
{
    ModelRequest models;          ///< one
    bool removesVertices = false; ///< one by one, instead of collapsing edges by error
    core::SimplifySettings simplify;
    RemovalRequest removal;
    ArrangementRequest arrangement;
    core::LadderSettings ladder;
    core::PmSettings file;
    std::filesystem::path output;
};

void printBuild(const Json& row)
{
    std::cout << row["model"].get<std::string>() << '\n';
    for (const auto& [key, value] : row.items())
        if (key != "model") std::cout << "  " << key << ": " << value.dump() << '\n';
}

foundation::Result<Json> build(const BuildRequest& request, const std::string& file)
{
    const auto model = readClean(file, request.models.limits);
    if (!model) return model.error();
    const auto arrangement = arrangementSettingsOf(request.arrangement);
    if (!arrangement) return arrangement.error();
    const core::Mesh& mesh = model->read.imported.mesh;
    core::SimplifySettings simplifySettings = request.simplify;
    simplifySettings.materialColours = materialColours(mesh, model->read.imported.states);
    core::CollapseSequence sequence;
    const double simplifyMs = millisecondsOf(
        [&]
        {
            sequence = request.removesVertices ? removalsOf(mesh, request.removal)
                                               : core::simplify(mesh, simplifySettings);
        });
    core::ProgressiveMesh progressive;
    const double arrangeMs =
        millisecondsOf([&] { progressive = core::buildProgressiveMesh(mesh, sequence, *arrangement); });
    const double measureMs = millisecondsOf([&] { core::measureLevels(progressive, request.ladder); });
    const ImportedModel& imported = model->read.imported;
    std::vector<osg::ref_ptr<osg::Node>> others;
    for (unsigned int i = 0; i < imported.remainder->getNumChildren(); ++i)
        others.push_back(imported.remainder->getChild(i));
    core::PmSettings settings = request.file;
    const auto folder = std::filesystem::path(file).parent_path();
    if (const auto attached = attachToPm(settings, imported.states, others, folder); !attached)
        return foundation::Error{file, attached.error().what, attached.error().remedy};
    const std::string bytes = core::pmBytes(progressive, settings);
    if (const auto written = foundation::writeWholeFile(request.output, bytes); !written)
        return written.error();
    Json row{{"model", file},
             {"file", request.output.string()},
             {"triangles", sequence.facesBefore},
             {"positions", progressive.mesh.positions.size()},
             {"vertices", progressive.mesh.wedgeCount()},
             {"steps", progressive.stepCount},
             {"fifo", arrangement->cacheSize},
             {"fileBytes", bytes.size()},
             {"overheadBytesPerVertex", static_cast<double>(progressive.overheadBytes()) /
                                            static_cast<double>(progressive.mesh.wedgeCount())},
             {"simplifyMs", simplifyMs},
             {"arrangeMs", arrangeMs},
             {"measureMs", measureMs}};
    printBuild(row);
    addLosses(row, model->read);
    printLosses(row);
    return row;
}

} // namespace

void addBuild(CLI::App& app, Chosen& chosen)
{
    const std::map<std::string, core::Arrangement> arrangements = {{"plain", core::Arrangement::plain},
                                                                   {"tswap", core::Arrangement::tswap},
                                                                   {"blocks", core::Arrangement::blocks},
                                                                   {"ours", core::Arrangement::windows}};
    const auto request = std::make_shared<BuildRequest>();
    CLI::App* command = app.add_subcommand("build", "make a progressive mesh, a .pm file, of a model");
    addModelOptions(*command, request->models, chosen.jsonFile);
    command->get_option("MODEL")->expected(1);
    command->add_option("-o,--output", request->output, "the .pm file to write")
        ->required()
        ->check(terminal::extension(".pm"));
    command
        ->add_option("--method", request->removesVertices,
                     "edges: collapses by error (default); removal: vertices one by one")
        ->transform(terminal::named(std::map<std::string, bool>{{"edges", false}, {"removal", true}}));
    addRemovalOptions(*command, request->removal);
    command
        ->add_option("--order", request->arrangement.settings.arrangement,
                     "order of the faces: plain, tswap, blocks, ours (default)")
        ->transform(terminal::named(arrangements));
    addArrangementOptions(*command, request->arrangement);
    command->add_flag("--quantised", request->file.quantised, "vertices in 16 and 8 bits");
    command->add_flag("!--shape-only", request->simplify.keepSeams, "let textures, normals and materials go");
    addQuadrics(*command, request->simplify.quadrics);
    command->callback(
        [request, command, &chosen]
        {
            for (const char* option : {"--support", "--support-depth"})
                if (!request->removesVertices && command->count(option) > 0)
                    throw CLI::ValidationError(option, "has a meaning with --method removal only");
            for (const char* option : {"--shape-only", "--quadrics"})
                if (request->removesVertices && command->count(option) > 0)
                    throw CLI::ValidationError(option, "has no meaning with --method removal");
            chosen.places.written = {request->output};
            chosen.places.read.assign(request->models.files.begin(), request->models.files.end()); // one
            chosen.work = [request]
            {
                return forEachModel(request->models.files,
                                    [&](const std::string& file) { return build(*request, file); });
            };
        });
}

} // namespace pmtool
