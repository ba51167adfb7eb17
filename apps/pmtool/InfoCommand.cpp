// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "pmtool/Models.h"
#include "pmtool/PmInfo.h"
#include "terminal/CommandLine.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;

nlohmann::ordered_json attributesOf(const core::Material& material)
{
    constexpr std::pair<core::Material::Attribute, const char*> kNames[] = {
        {core::Material::normal, "normal"},
        {core::Material::texCoord0, "texCoord0"},
        {core::Material::texCoord1, "texCoord1"},
        {core::Material::colour, "colour"}};
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const auto& [attribute, name] : kNames)
        if (material.has(attribute))
            names.push_back((material.unseen & attribute) ? std::string(name) + " (unseen)" : name);
    return names;
}

nlohmann::ordered_json describe(const std::string& file, const ReadModel& model)
{
    const core::Mesh& mesh = model.imported.mesh;
    const core::MeshCounts counts = core::countMesh(mesh);
    nlohmann::ordered_json row{{"model", file}};
    row.update(tableOf(counts));
    row["boundaryEdges"] = counts.boundaryEdges;
    row["diagonal"] = core::diagonalOf(mesh);
    row["parts"] = mesh.parts.size();
    row["materials"] = nlohmann::ordered_json::array();
    for (const core::Material& material : mesh.materials)
        row["materials"].push_back({{"name", material.name},
                                    {"attributes", attributesOf(material)},
                                    {"twoSided", material.isTwoSided},
                                    {"transparent", material.isTransparent}});
    row["import"] = tableOf(model.imported.report);
    row["notes"] = model.notes;
    return row;
}

foundation::Result<nlohmann::ordered_json> rowOf(const std::string& file, const ReadLimits& limits)
{
    if (isPmFile(file)) return describePm(file);
    const auto model = read(file, limits);
    if (!model) return model.error();
    return describe(file, *model);
}

void printInfo(const nlohmann::ordered_json& row)
{
    std::cout << row["model"].get<std::string>() << '\n';
    for (const auto& [key, value] : row.items())
        if (key == "materials" || key == "notes" || key == "levels" || key == "images")
            for (const auto& entry : value)
                std::cout << "  " << key.substr(0, key.size() - 1) << ": "
                          << (entry.is_string() ? entry.get<std::string>() : entry.dump()) << '\n';
        else if (key == "ladder")
            std::cout << "  measured levels: " << value.size() << '\n';
        else if (key != "model" && !(value.is_object() && value.empty()))
            std::cout << "  " << key << ": " << value.dump() << '\n';
}

} // namespace

void addInfo(CLI::App& app, Chosen& chosen)
{
    const auto request = std::make_shared<ModelRequest>();
    CLI::App* info = app.add_subcommand(
        "info", "print triangles, defects, parts and materials of each model; levels of each .pm file");
    addModelOptions(*info, *request, chosen.jsonFile);
    info->callback(
        [request, &chosen]
        {
            chosen.work = [request]
            {
                return forEachModel(request->files,
                                    [&](const std::string& file) -> foundation::Result<nlohmann::ordered_json>
                                    {
                                        auto row = rowOf(file, request->limits);
                                        if (row) printInfo(*row);
                                        return row;
                                    });
            };
        });
}

} // namespace pmtool
