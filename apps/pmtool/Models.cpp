// SPDX-License-Identifier: Apache-2.0
#include "pmtool/Models.h"

#include <iostream>
#include <new>

#include <osgPMObjects/core/simplify/Simplifiable.h>

#include "terminal/CommandLine.h"
#include "terminal/Guard.h"
#include "terminal/Progress.h"
#include "terminal/Terminal.h"

namespace pmtool
{

using namespace osgPMObjects;

void addJsonOption(CLI::App& command, std::filesystem::path& jsonFile)
{
    command.add_option("--json", jsonFile, "write the table there, too");
}

void addModelOptions(CLI::App& command, ModelRequest& request, std::filesystem::path& jsonFile)
{
    command.add_option("MODEL", request.files, "files that OpenSceneGraph reads, .gltf, .glb, .pm")
        ->required();
    addJsonOption(command, jsonFile);
    command.add_option("--seconds", request.limits.seconds, "most time to read a model, in seconds (120)")
        ->check(terminal::between(0.1, 86400.0));
    command.add_option("--memory", request.limits.memoryMiB, "most memory to read a model, MiB (8192)")
        ->check(CLI::Range(64, 1 << 20));
}

foundation::Result<ReadModel> read(const std::string& file, const ReadLimits& limits,
                                   const std::function<void(osg::Node&)>& prepare)
{
    const auto node = readModelNode(file, limits);
    if (!node) return node.error();
    if (prepare) prepare(**node);
    auto imported = importNode(**node, file);
    if (!imported) return imported.error();
    return ReadModel{std::move(*imported), (*node)->getDescriptions()};
}

foundation::Result<CleanModel> readClean(const std::string& file, const ReadLimits& limits)
{
    auto model = read(file, limits);
    if (!model) return model.error();
    core::Mesh& mesh = model->imported.mesh;
    const std::size_t trianglesRead = mesh.faces.size();
    core::makeSimplifiable(mesh);
    if (mesh.faces.empty())
        return foundation::Error{file, "has no triangles that can be simplified",
                                 "give a model with surfaces"};
    return CleanModel{*std::move(model), trianglesRead};
}

namespace
{

/// Does the work on a file. Memory that cannot be had is an error of that file.
template<class Work>
foundation::Result<nlohmann::ordered_json> resultOf(const Work& work, const std::string& file)
{
    try
    {
        return work(file);
    }
    catch (const std::bad_alloc&)
    {
        return terminal::outOfMemory(file);
    }
}

} // namespace

foundation::Result<terminal::Report>
forEachModel(const std::vector<std::string>& files,
             const std::function<foundation::Result<nlohmann::ordered_json>(const std::string& file)>& work,
             const std::string& program)
{
    terminal::Report report;
    report.json["models"] = nlohmann::ordered_json::array();
    terminal::Progress progress("pmtool", files.size());
    for (const std::string& file : files)
    {
        progress.begin(file, 1);
        auto row = resultOf(work, file);
        if (row)
            report.json["models"].push_back(std::move(*row));
        else
        {
            terminal::fail(program, row.error());
            report.sound = false;
        }
    }
    return report;
}

nlohmann::ordered_json tableOf(const core::MeshCounts& counts)
{
    return {{"triangles", counts.triangles},
            {"positions", counts.positions},
            {"attributeVertices", counts.attributeVertices},
            {"tJunctions", counts.tJunctions},
            {"duplicates", counts.duplicates},
            {"degenerates", counts.degenerates},
            {"nonManifoldEdges", counts.nonManifoldEdges},
            {"components", counts.components}};
}

nlohmann::ordered_json tableOf(const ImportReport& report)
{
    nlohmann::ordered_json table = nlohmann::ordered_json::object();
    const auto add = [&](const char* name, std::size_t count)
    {
        if (count > 0) table[name] = count;
    };
    add("keptDrawables", report.keptDrawables);
    add("keptNodes", report.keptNodes);
    add("coarserLevels", report.coarserLevels);
    add("hiddenChildren", report.hiddenChildren);
    add("unloadedChildren", report.unloadedChildren);
    add("bakedAnimations", report.bakedAnimations);
    add("refusedFaces", report.refusedFaces);
    add("refusedPrimitives", report.refusedPrimitives);
    add("zeroedAttributes", report.zeroedAttributes);
    add("droppedArrays", report.droppedArrays);
    add("droppedComponents", report.droppedComponents);
    return table;
}

void addLosses(nlohmann::ordered_json& row, const ReadModel& model)
{
    if (auto losses = tableOf(model.imported.report); !losses.empty()) row["import"] = std::move(losses);
    if (!model.notes.empty()) row["notes"] = model.notes;
}

void printLosses(const nlohmann::ordered_json& row)
{
    if (row.contains("import"))
        for (const auto& [what, count] : row["import"].items())
            std::cout << "  import: " << what << ' ' << count << '\n';
    if (row.contains("notes"))
        for (const auto& note : row["notes"])
            std::cout << "  note: " << note.get<std::string>() << '\n';
}

} // namespace pmtool
