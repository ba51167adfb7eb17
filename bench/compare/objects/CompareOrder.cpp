// SPDX-License-Identifier: Apache-2.0
#include <iomanip>
#include <iostream>
#include <memory>
#include <system_error>

#include <foundation/WholeFile.h>

#include "compare/objects/Commands.h"
#include "compare/objects/OrderRow.h"
#include "pmtool/Models.h"
#include "terminal/CommandLine.h"
#include "terminal/Terminal.h"

namespace pmtool
{

namespace
{

struct OrderRequest
{
    ModelRequest models;
    std::filesystem::path dumpFolder;
};

/// Indices of all draw calls, one after the other, as a graphics card takes them; four bytes each, lowest
/// first.
foundation::Outcome dumpIndices(const std::filesystem::path& file, const OrderedSubject& ordered)
{
    std::string bytes;
    for (const auto& call : ordered.calls)
        for (const auto& triangle : call)
            for (const std::uint32_t vertex : triangle)
                for (int shift = 0; shift < 32; shift += 8)
                    bytes.push_back(static_cast<char>(vertex >> shift & 0xffu));
    return foundation::writeWholeFile(file, bytes);
}

void printOrder(const std::string& order, const nlohmann::ordered_json& row)
{
    std::cout << "  " << std::left << std::setw(16) << order << std::right << std::fixed
              << std::setprecision(3);
    for (const char* cache : {"fifo10", "fifo16", "fifo32", "batch32"})
        std::cout << std::setw(8) << row["transformsPerTriangle"][cache].get<double>();
    std::cout << std::setprecision(1) << std::setw(10) << row["ms"].get<double>() << '\n';
}

foundation::Result<nlohmann::ordered_json>
compareOrders(const OrderSubject& subject, const std::string& model, const std::filesystem::path& dumpFolder)
{
    nlohmann::ordered_json json = {{"vertices", subject.vertices},
                                   {"vertexCount", subject.vertexCount()},
                                   {"drawCalls", nlohmann::ordered_json::array()},
                                   {"orders", nlohmann::ordered_json::array()}};
    for (const DrawCall& call : subject.calls)
        json["drawCalls"].push_back(
            {{"triangles", call.triangles.size()}, {"vertices", call.positions.size()}});
    std::cout << model << ", " << subject.vertices << ": " << subject.triangleCount() << " triangles, "
              << subject.vertexCount()
              << " vertices\n  transforms per triangle  fifo10  fifo16  fifo32 batch32        ms\n";
    for (const std::string& order : orderNames())
    {
        const OrderedSubject ordered = orderSubject(subject, order);
        nlohmann::ordered_json row = {{"order", order},
                                      {"transformsPerTriangle", transformsPerTriangle(subject, ordered)},
                                      {"ms", ordered.ms}};
        if (ordered.strips > 0)
        {
            row["strips"] = ordered.strips;
            row["sentPerTriangle"] =
                static_cast<double>(ordered.sentVertices) / static_cast<double>(subject.triangleCount());
        }
        if (!dumpFolder.empty())
        {
            const std::string file = model + "." + subject.vertices + "." + order + ".u32";
            if (const auto written = dumpIndices(dumpFolder / file, ordered); !written)
                return written.error();
            row["dump"] = file;
        }
        printOrder(order, row);
        json["orders"].push_back(std::move(row));
    }
    return json;
}

foundation::Result<nlohmann::ordered_json> compareModel(const std::string& file, const std::string& number,
                                                        const OrderRequest& request)
{
    auto model = read(file, request.models.limits);
    if (!model) return model.error();
    if (model->imported.mesh.faces.empty())
        return foundation::Error{file, "has no triangles", "give a model with surfaces"};
    const auto subjects = orderSubjects(std::move(model->imported.mesh));
    nlohmann::ordered_json row = {{"model", file},
                                  {"triangles", subjects.front().triangleCount()},
                                  {"meshes", nlohmann::ordered_json::array()}};
    const std::string name = number + "-" + std::filesystem::path(file).filename().string();
    for (const OrderSubject& subject : subjects)
    {
        auto mesh = compareOrders(subject, name, request.dumpFolder);
        if (!mesh) return mesh.error();
        row["meshes"].push_back(*std::move(mesh));
    }
    return row;
}

foundation::Result<terminal::Report> compareModelOrders(const OrderRequest& request)
{
    std::error_code failed;
    if (!request.dumpFolder.empty()) std::filesystem::create_directories(request.dumpFolder, failed);
    if (failed)
        return foundation::Error{request.dumpFolder.string(), "cannot be made: " + failed.message(),
                                 "name another folder"};
    std::size_t number = 0; // files of the same name in different folders have dumps of their own
    return forEachModel(
        request.models.files,
        [&](const std::string& file) { return compareModel(file, std::to_string(number++), request); },
        kComparer);
}

} // namespace

void addCompareOrder(CLI::App& app, Chosen& chosen)
{
    const auto request = std::make_shared<OrderRequest>();
    CLI::App* sub = app.add_subcommand(
        "order", "orders of triangles, by vertices transformed per triangle for several caches");
    addModelOptions(*sub, request->models, chosen.jsonFile);
    sub->add_option("--dump", request->dumpFolder, "write the indices of every order to this folder");
    sub->callback([&chosen, request] { chosen.work = [request] { return compareModelOrders(*request); }; });
}

} // namespace pmtool
