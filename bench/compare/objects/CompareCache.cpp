// SPDX-License-Identifier: Apache-2.0
#include <iomanip>
#include <iostream>
#include <memory>

#include "compare/objects/CacheRow.h"
#include "compare/objects/Commands.h"
#include "compare/objects/SimplifyTool.h"
#include "pmtool/ArrangementOptions.h"
#include "pmtool/Models.h"
#include "terminal/CommandLine.h"

namespace pmtool
{

namespace
{

using Json = nlohmann::ordered_json;

struct CacheRequest
{
    ModelRequest models;
    std::size_t levels = 41;
    ArrangementRequest arrangement;
};

void printCacheRow(const Json& row)
{
    const auto number = [&](const char* key, int width, int digits)
    {
        std::cout << std::setw(width);
        if (row.contains(key))
            std::cout << std::setprecision(digits) << row[key].get<double>();
        else
            std::cout << "";
    };
    std::cout << "  " << std::left << std::setw(12) << row["order"].get<std::string>() << std::right
              << std::fixed;
    number("meanTransformsPerVertex", 8, 3);
    number("worstLevel", 8, 3);
    number("faceWritesPerEcol", 10, 2);
    number("nsPerStep", 10, 1);
    number("bytesPerVertex", 8, 1);
    std::cout << '\n';
}

Json compareOrders(const CacheSubject& subject, const std::string& model, const char* vertices)
{
    std::cout << model << ", " << vertices << ": " << subject.mesh.faces.size() << " triangles, "
              << subject.mesh.wedgeCount() << " vertices\n"
              << "  order           mean   worst    writes   ns/step B/vertex\n";
    Json rows = Json::array();
    for (const std::string& order : cacheOrderNames())
    {
        rows.push_back(cacheRow(subject, order));
        printCacheRow(rows.back());
    }
    return rows;
}

foundation::Result<Json> compareModel(const std::string& file, const CacheRequest& request)
{
    auto model = readClean(file, request.models.limits);
    if (!model) return model.error();
    const auto settings = arrangementSettingsOf(request.arrangement);
    if (!settings) return settings.error();
    const CacheSubject shape(shapeOf(model->read.imported.mesh), request.levels, *settings);
    Json row{{"model", file},
             {"triangles", shape.mesh.faces.size()},
             {"vertices", shape.mesh.wedgeCount()},
             {"orders", compareOrders(shape, file, "positions")}};
    const CacheSubject drawn(std::move(model->read.imported.mesh), request.levels, *settings);
    row["asDrawn"] = {{"vertices", drawn.mesh.wedgeCount()},
                      {"orders", compareOrders(drawn, file, "as drawn")}};
    return row;
}

} // namespace

void addCompareCache(CLI::App& app, Chosen& chosen)
{
    const auto request = std::make_shared<CacheRequest>();
    CLI::App* sub = app.add_subcommand(
        "cache", "arrangements of the faces of progressive meshes, by vertices transformed at all levels");
    addModelOptions(*sub, request->models, chosen.jsonFile);
    sub->add_option("--levels", request->levels, "number of levels measured, evenly spaced (41)")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    addArrangementOptions(*sub, request->arrangement);
    sub->callback(
        [&chosen, request]
        {
            chosen.work = [request]
            {
                return forEachModel(
                    request->models.files,
                    [&](const std::string& file) { return compareModel(file, *request); }, kComparer);
            };
        });
}

} // namespace pmtool
