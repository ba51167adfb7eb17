// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>

#include <osgPMObjects/core/simplify/Simplify.h>

#include <osgPMObjects/BakeModel>

#include "pmtool/ModelFiles.h"
#include "pmtool/Models.h"
#include "pmtool/Timing.h"
#include "terminal/CommandLine.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
using Json = nlohmann::ordered_json;

struct BakeRequest
{
    ModelRequest models;
    BakeModelSettings bake;
    double levelPercent = 10.0;
    std::optional<std::size_t> faces; ///< instead of a percentage
    std::filesystem::path outputFolder;
    std::string format = "osgb";
};

core::Mesh simplified(const core::Mesh& mesh, const BakeRequest& request)
{
    const auto share = static_cast<std::size_t>(
        std::llround(static_cast<double>(mesh.faces.size()) * request.levelPercent / 100.0));
    const std::size_t faces = std::max<std::size_t>(1, request.faces.value_or(share));
    const core::CollapseSequence sequence = core::simplify(mesh, {.placement = core::Placement::optimal});
    return core::meshAfter(mesh, sequence, core::stepsToFaces(sequence, faces));
}

Json rowOf(const BakeReport& report)
{
    return {{"charts", report.charts},
            {"atlasUsePercent", report.coveredPercent},
            {"texelsPerUnit", report.texelsPerUnit},
            {"unmatchedPercent", report.unmatchedPercent},
            {"reach", report.reach},
            {"texturesNotRead", report.texturesNotRead}};
}

void printBake(const Json& row)
{
    std::cout << row["model"].get<std::string>() << ": " << row["triangles"] << " -> "
              << row["trianglesReached"] << " triangles, " << row["charts"] << " charts on " << std::fixed
              << std::setprecision(1) << row["atlasUsePercent"].get<double>() << " % of " << row["size"]
              << " x " << row["size"] << ", " << row["unmatchedPercent"].get<double>()
              << " % without a match, " << row["ms"]["simplify"].get<double>() << " ms simplified, "
              << row["ms"]["charts"].get<double>() + row["ms"]["maps"].get<double>() << " ms baked\n";
    if (row["texturesNotRead"] > 0)
        std::cout << "  " << row["texturesNotRead"]
                  << " textures could not be read (compressed, or not found)\n";
}

foundation::Result<Json> bakeFile(const BakeRequest& request, OutputNames& names, const std::string& file)
{
    auto model = readClean(file, request.models.limits);
    if (!model) return model.error();
    ImportedModel& full = model->read.imported;
    core::Mesh level;
    const double simplifyMs = millisecondsOf([&] { level = simplified(full.mesh, request); });
    const auto baked = bakeModel(full, level, request.bake);
    if (!baked) return foundation::Error{file, baked.error().what, baked.error().remedy};
    Json row{{"model", file},
             {"triangles", full.mesh.faces.size()},
             {"trianglesReached", level.faces.size()},
             {"size", request.bake.atlas.sizePx}};
    row.update(rowOf(baked->report));
    row["ms"] = {{"simplify", simplifyMs}, {"charts", baked->report.chartMs}, {"maps", baked->report.mapMs}};
    if (!request.outputFolder.empty())
    {
        const auto target = request.outputFolder / (names.nameFor(file) + '.' + request.format);
        if (const auto written = writeModel(baked->model, target); !written) return written.error();
        row["output"] = target.string();
    }
    printBake(row);
    return row;
}

foundation::Result<terminal::Report> bakeModels(const BakeRequest& request)
{
    if (!request.outputFolder.empty())
        if (const auto made = makeFolder(request.outputFolder); !made) return made.error();
    OutputNames names;
    return forEachModel(request.models.files,
                        [&](const std::string& file) { return bakeFile(request, names, file); });
}

} // namespace

void addBake(CLI::App& app, Chosen& chosen)
{
    const auto request = std::make_shared<BakeRequest>();
    CLI::App* command =
        app.add_subcommand("bake", "simplify each model and keep its appearance in colour and normal maps");
    addModelOptions(*command, request->models, chosen.jsonFile);
    CLI::Option* level = command->add_option("--level", request->levelPercent, "faces to keep, per cent (10)")
                             ->check(terminal::between(0.01, 100.0));
    command->add_option("--faces", request->faces, "faces to keep")
        ->check(CLI::Range(1, 1 << 30))
        ->excludes(level);
    command
        ->add_option("--size", request->bake.atlas.sizePx,
                     "side of the maps in texels, a power of two (1024)")
        ->check(CLI::IsMember({16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192}));
    command->add_option("--gutter", request->bake.atlas.gutterPx, "texels left free around each chart (3)")
        ->check(CLI::Range(1, 64));
    command
        ->add_option("--slant", request->bake.charts.mostSlantDeg,
                     "largest angle of a face to its chart, degrees (55)")
        ->check(terminal::between(1.0, 85.0));
    command
        ->add_option("--samples", request->bake.maps.samplesPerSide, "samples along each side of a texel (2)")
        ->check(CLI::Range(1, 8));
    command->add_option("--output", request->outputFolder, "folder for the models, with their maps inside");
    command->add_option("--format", request->format, "format of the models (osgb)")
        ->check(CLI::IsMember({"osgb", "osgt", "ive"}));
    command->callback([request, &chosen] { chosen.work = [request] { return bakeModels(*request); }; });
}

} // namespace pmtool
