// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>

#include <osgPMObjects/core/order/FaceOrder.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "pmtool/ModelFiles.h"
#include "pmtool/Models.h"
#include "pmtool/Timing.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
using Json = nlohmann::ordered_json;

struct SimplifyRequest
{
    ModelRequest models;
    core::SimplifySettings settings;
    std::vector<double> targetsPercent;
    std::vector<double> tolerances; ///< units of the model
    double envelopePercent = 0.0;   ///< of the diagonal
    double joinPercent = 0.0;       ///< the same
    std::filesystem::path outputFolder;
    std::string format = "osgb";
};

/// What a level was asked for by, as its file's name says it.
struct Wish
{
    std::string name;
    std::size_t steps = 0;
};

std::string shortest(double value)
{
    std::ostringstream text;
    text << value;
    return text.str();
}

std::vector<Wish> wishesOf(const SimplifyRequest& request, const core::CollapseSequence& sequence)
{
    std::vector<Wish> wishes;
    for (const double percent : request.targetsPercent)
    {
        const double faces = static_cast<double>(sequence.facesBefore) * percent / 100.0;
        wishes.push_back({shortest(percent) + "pc",
                          core::stepsToFaces(sequence, static_cast<std::size_t>(std::llround(faces)))});
    }
    for (const double tolerance : request.tolerances)
        wishes.push_back({shortest(tolerance) + "m", core::stepsToDistance(sequence, tolerance)});
    return wishes;
}

Json rowOf(const core::CollapseSequence& sequence, const Wish& wish)
{
    const core::LevelError error = wish.steps > 0 ? sequence.steps[wish.steps - 1].error : core::LevelError();
    return {{"level", wish.name},
            {"triangles", wish.steps > 0 ? sequence.steps[wish.steps - 1].facesAfter : sequence.facesBefore},
            {"distance", error.distance},
            {"normal", error.normal},
            {"texCoord", error.texCoord},
            {"colour", error.colour}};
}

foundation::Outcome writeLevel(const ImportedModel& model, core::Mesh level,
                               const std::filesystem::path& file)
{
    core::orderFaces(level, core::FaceOrder::library);
    return writeModel({std::move(level), model.states, model.remainder, {}}, file);
}

foundation::Result<Json> simplifyFile(const SimplifyRequest& request, OutputNames& names,
                                      const std::string& file)
{
    auto model = readClean(file, request.models.limits);
    if (!model) return model.error();
    const ImportedModel& imported = model->read.imported;
    const core::Mesh& mesh = imported.mesh;
    core::SimplifySettings settings = request.settings;
    const double diagonal = core::diagonalOf(mesh);
    settings.envelope = request.envelopePercent / 100.0 * diagonal;
    settings.joinDistance = request.joinPercent / 100.0 * diagonal;
    core::CollapseSequence sequence;
    const double ms = millisecondsOf([&] { sequence = core::simplify(mesh, settings); });
    Json row{{"model", file},
             {"triangles", sequence.facesBefore},
             {"least", sequence.steps.empty() ? sequence.facesBefore : sequence.steps.back().facesAfter},
             {"ms", ms},
             {"levels", Json::array()}};
    std::cout << file << ": " << row["triangles"] << " triangles, at least " << row["least"] << ", "
              << row["ms"] << " ms\n";
    const std::string name = names.nameFor(file);
    for (const Wish& wish : wishesOf(request, sequence))
    {
        Json level = rowOf(sequence, wish);
        const std::string written = name + '.' + wish.name + '.' + request.format;
        if (!request.outputFolder.empty())
        {
            if (const auto done = writeLevel(imported, core::meshAfter(mesh, sequence, wish.steps),
                                             request.outputFolder / written);
                !done)
                return done.error();
            level["file"] = written;
        }
        std::cout << "  " << std::setw(8) << wish.name << std::setw(9) << level["triangles"]
                  << " triangles, off by " << level["distance"] << ", texture by " << level["texCoord"]
                  << '\n';
        row["levels"].push_back(std::move(level));
    }
    return row;
}

foundation::Result<terminal::Report> simplifyModels(SimplifyRequest request)
{
    if (request.targetsPercent.empty() && request.tolerances.empty()) request.targetsPercent = {25, 5, 1};
    if (!request.outputFolder.empty())
        if (const auto made = makeFolder(request.outputFolder); !made) return made.error();
    OutputNames names;
    return forEachModel(request.models,
                        [&](const std::string& file) { return simplifyFile(request, names, file); });
}

} // namespace

void addSimplify(CLI::App& app, Chosen& chosen)
{
    const std::map<std::string, core::Placement> placements = {{"subset", core::Placement::subset},
                                                               {"optimal", core::Placement::optimal},
                                                               {"quality", core::Placement::quality}};
    const auto request = std::make_shared<SimplifyRequest>();
    request->settings.placement = core::Placement::optimal;
    CLI::App* command = app.add_subcommand("simplify", "levels of each model with fewer triangles");
    addModelOptions(*command, request->models, chosen.jsonFile);
    command->add_option("--targets", request->targetsPercent, "triangles to keep, per cent (25,5,1)")
        ->delimiter(',')
        ->check(terminal::between(0.001, 100.0));
    command->add_option("--tolerances", request->tolerances, "levels by their error, in the model's unit")
        ->delimiter(',')
        ->check(terminal::between(0.0, 1e9));
    command
        ->add_option("--placement", request->settings.placement,
                     "of vertices: subset, optimal (default), quality")
        ->transform(CLI::CheckedTransformer(placements));
    command
        ->add_option("--envelope", request->envelopePercent,
                     "never farther from the original than this part of the diagonal, per cent (0: no limit)")
        ->check(terminal::between(0.0, 100.0));
    command
        ->add_option("--join", request->joinPercent,
                     "parts no farther apart than this part of the diagonal may join, per cent (0: none)")
        ->check(terminal::between(0.0, 100.0));
    command->add_flag("!--shape-only", request->settings.keepSeams, "let textures, normals and materials go");
    command->add_flag("!--lopsided", request->settings.keepSymmetry, "do not keep models symmetric that are");
    command->add_flag("!--thin-leaves", request->settings.growLeaves,
                      "let leaf cards vanish without others growing");
    command->add_option("--output", request->outputFolder, "write the levels there, NAME.LEVEL.FORMAT");
    command->add_option("--format", request->format, "of the levels written (osgb)")
        ->check(CLI::IsMember({"osgb", "osgt", "ive"}));
    command->callback([request, &chosen] { chosen.work = [request] { return simplifyModels(*request); }; });
}

} // namespace pmtool
