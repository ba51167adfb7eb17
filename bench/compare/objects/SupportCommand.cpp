// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <utility>

#include <foundation/WholeFile.h>

#include <osgPMObjects/core/consolidate/Consolidate.h>

#include "compare/objects/ChartSvg.h"
#include "compare/objects/Commands.h"
#include "compare/objects/DistanceChart.h"
#include "compare/objects/SupportCurves.h"
#include "pmtool/ModelFiles.h"
#include "pmtool/Models.h"
#include "terminal/CommandLine.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
using Json = nlohmann::ordered_json;

const std::map<std::string, core::RemovalOrder> kRemovalOrders{{"flattest", core::RemovalOrder::flattest},
                                                               {"file", core::RemovalOrder::asNumbered},
                                                               {"shuffled", core::RemovalOrder::shuffled}};

struct SupportRequest
{
    ModelRequest models;
    std::filesystem::path outputFolder;
    std::uint32_t depth = 3;
    bool keepSeams = false;
    core::RemovalOptions removal;
};

Json rowOf(const SupportVariant& v, std::size_t toQuarter, std::size_t toFewest)
{
    Json left = Json::object();
    for (std::size_t reason = 0; reason < core::kRemovalRefusals; ++reason)
        if (v.sequence.left[reason] > 0)
            left[core::nameOf(static_cast<core::RemovalRefusal>(reason))] = v.sequence.left[reason];
    return {{"support", v.name},
            {"supportVertices", v.supportVertices},
            {"removed", v.sequence.steps.size()},
            {"left", left},
            {"fewestFaces", v.curve.faces.back()},

            {"deviationToQuarterPercent", 100.0 * v.curve.meanDeviation(toQuarter)},
            {"deviationToFewestPercent", 100.0 * v.curve.meanDeviation(toFewest)},
            {"ms", v.ms}};
}

/// Returns the name of the variant whose figure is the least.
std::string bestBy(const Json& curves, const char* figure)
{
    const auto best = std::min_element(curves.begin(), curves.end(),
                                       [&](const Json& a, const Json& b) { return a[figure] < b[figure]; });
    return (*best)["support"].get<std::string>();
}

void printCurves(const std::string& file, const Json& row)
{
    std::cout << file << ": " << row["triangles"].dump() << " triangles\n"
              << "  support                vertices  fewest faces  area off to a quarter, %  to "
              << row["toFewest"].dump() << " faces, %      ms\n";
    for (const Json& curve : row["curves"])
        std::cout << "  " << std::left << std::setw(20) << curve["support"].get<std::string>() << std::right
                  << std::setw(11) << curve["supportVertices"].dump() << std::setw(14)
                  << curve["fewestFaces"].dump() << std::fixed << std::setprecision(3) << std::setw(26)
                  << curve["deviationToQuarterPercent"].get<double>() << std::setw(17)
                  << curve["deviationToFewestPercent"].get<double>() << std::setprecision(1) << std::setw(11)
                  << curve["ms"].get<double>() << '\n';
}

/// Results of all models together.
struct Findings
{
    OutputNames names;
    std::vector<AreaPanel> panels;
    std::vector<std::string> distancePanels;
};

foundation::Result<Json> study(const SupportRequest& request, Findings& findings, const std::string& file)
{
    auto model = read(file, request.models.limits);
    if (!model) return model.error();
    core::consolidate(model->imported.mesh);
    const core::Mesh shape =
        request.keepSeams ? std::move(model->imported.mesh) : core::shapeOf(model->imported.mesh);
    if (shape.faces.empty()) return foundation::Error{file, "has no triangles", "give a model with surfaces"};
    std::vector<SupportVariant> variants;
    for (const NamedSupportRule& rule : kSupportRules)
        variants.push_back(removeWith(shape, rule, request.depth, request.removal));
    std::size_t toFewest = 0;
    for (const SupportVariant& v : variants)
        toFewest = std::max(toFewest, v.curve.faces.back());
    const std::size_t toQuarter = std::max(toFewest, shape.faces.size() / 4);
    Json row{{"model", file},
             {"triangles", shape.faces.size()},
             {"positions", variants.front().sequence.positionCount},
             {"area", variants.front().curve.areas.front()},
             {"toQuarter", toQuarter},
             {"toFewest", toFewest},
             {"curves", Json::array()}};
    for (const SupportVariant& v : variants)
        row["curves"].push_back(rowOf(v, toQuarter, toFewest));
    row["bestToQuarter"] = bestBy(row["curves"], "deviationToQuarterPercent");
    row["bestToFewest"] = bestBy(row["curves"], "deviationToFewestPercent");
    printCurves(file, row);
    const std::string name = findings.names.nameFor(file);
    findings.panels.push_back(panelOf(name, variants));
    std::vector<DistanceLine> lines;
    for (const SupportVariant& v : variants)
        lines.push_back({std::to_string(lines.size() + 1) + ' ' + v.name, v.sequence});
    findings.distancePanels.push_back(distancePanel(name, lines));
    if (request.outputFolder.empty()) return row;
    const auto written = foundation::writeWholeFile(request.outputFolder / (name + ".csv"), csvOf(variants));
    if (!written) return written.error();
    return row;
}

foundation::Result<terminal::Report> compareSupports(const SupportRequest& request)
{
    if (!request.outputFolder.empty())
        if (const auto made = makeFolder(request.outputFolder); !made) return made.error();
    Findings findings;
    auto report = forEachModel(
        request.models.files, [&](const std::string& file) { return study(request, findings, file); },
        kComparer);
    if (!report) return report;
    Json& table = report->json;
    table["octreeDepth"] = request.depth;
    for (const char* best : {"bestToQuarter", "bestToFewest"})
    {
        for (const NamedSupportRule& rule : kSupportRules)
            table[best][rule.name] = std::count_if(table["models"].begin(), table["models"].end(),
                                                   [&](const Json& row) { return row[best] == rule.name; });
        std::cout << best << ": " << table[best].dump() << '\n';
    }
    if (request.outputFolder.empty() || findings.panels.empty()) return report;
    for (const auto& [name, chart] : {std::pair{"area-curves.svg", areaChart(findings.panels)},
                                      {"distance-curves.svg", svgSheet(findings.distancePanels)}})
        if (const auto written = foundation::writeWholeFile(request.outputFolder / name, chart); !written)
            return written.error();
    return report;
}

} // namespace

void addSupport(CLI::App& app, Chosen& chosen)
{
    const auto request = std::make_shared<SupportRequest>();
    CLI::App* command = app.add_subcommand(
        "support", "measure how the area changes as vertices are removed, with and without support vertices");
    addModelOptions(*command, request->models, chosen.jsonFile);
    command->add_option(
        "--output", request->outputFolder,
        "folder for the curves: NAME.csv, and area-curves.svg and distance-curves.svg of all models");
    command->add_option("--depth", request->depth, "depth of the octree: 2^depth cells along each axis (3)")
        ->check(CLI::Range(0, 10));
    command
        ->add_option("--order", request->removal.order,
                     "order of removal: flattest, file or shuffled (flattest)")
        ->transform(terminal::named(kRemovalOrders));
    command
        ->add_option("--crease", request->removal.creaseAngleDeg,
                     "where two edges sharper than this meet, a vertex is removed along them, degrees (40)")
        ->check(terminal::between(0.0, 180.0));
    command->add_flag_function(
        "--fans", [request](std::int64_t) { request->removal.triangulation = core::HoleTriangulation::fan; },
        "fill holes by fans, as the levels of pmtool build --method removal do; otherwise by Delaunay's "
        "method");
    command->add_flag(
        "--seams", request->keepSeams,
        "keep seams of attributes and borders of materials and parts; otherwise only the shape counts");
    command->callback([request, &chosen] { chosen.work = [request] { return compareSupports(*request); }; });
}

} // namespace pmtool
