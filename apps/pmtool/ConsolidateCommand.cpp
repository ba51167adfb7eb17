// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/mesh/SurfaceChange.h>
#include <osgPMObjects/core/order/FaceOrder.h>
#include <osgPMObjects/core/order/TriangleOrders.h>
#include <osgPMObjects/core/order/TriangleStrips.h>

#include "pmtool/ModelFiles.h"
#include "pmtool/Models.h"
#include "pmtool/QuadDiagonals.h"
#include "pmtool/Timing.h"
#include "terminal/CommandLine.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
using Json = nlohmann::ordered_json;

/// Orders of faces: those of a mesh, and Hilbert's.
enum class Order
{
    file,
    library,
    universal,
    locality,
    hilbert,
};

const std::map<std::string, Order> kFaceOrders{{"file", Order::file},
                                               {"library", Order::library},
                                               {"universal", Order::universal},
                                               {"locality", Order::locality},
                                               {"hilbert", Order::hilbert}};

enum class Strips
{
    none,
    sgi,
    dual,
};

const std::map<std::string, Strips> kStrips{
    {"none", Strips::none}, {"sgi", Strips::sgi}, {"dual", Strips::dual}};

const std::map<std::string, core::DiagonalRule> kDiagonals{
    {"colours", core::DiagonalRule::leastColourDifference},
    {"normals", core::DiagonalRule::leastNormalDifference},
    {"angle", core::DiagonalRule::largestNormalAngle},
    {"areas", core::DiagonalRule::nearestAreas},
    {"heights", core::DiagonalRule::nearestHeights},
    {"height-difference", core::DiagonalRule::largestHeightDifference}};

struct ConsolidateRequest
{
    ModelRequest models;
    core::ConsolidateOptions options;
    std::filesystem::path outputFolder, dumpFolder;
    std::string format = "osgb";
    Order order = Order::library;
    Strips strips = Strips::none;
    std::optional<core::DiagonalRule> diagonal; ///< of quads; without it as OpenGL draws them
};

void orderAsAsked(core::Mesh& mesh, Order order)
{
    switch (order)
    {
    case Order::file:
        return;
    case Order::hilbert:
        return core::orderFaces(mesh, core::hilbertOrder);
    case Order::universal:
        return core::orderFaces(mesh, core::FaceOrder::universal);
    case Order::locality:
        return core::orderFaces(mesh, core::FaceOrder::locality);
    case Order::library:
        return core::orderFaces(mesh, core::FaceOrder::library);
    }
}

/// What makes the strips of a geometry; empty: they are triangles.
StripMaker stripsAsAsked(Strips strips)
{
    if (strips == Strips::none) return {};
    const auto kind = strips == Strips::sgi ? core::StripKind::sgi : core::StripKind::dualGraph;
    return [kind](std::span<const core::Triangle> triangles, std::uint32_t vertexCount)
    { return core::joinStrips(triangles, core::stripsOf(triangles, vertexCount, kind)); };
}

/// A model, and what was done to its quads before the import.
struct QuadModel
{
    ReadModel model;
    QuadCounts quads;
};

foundation::Result<QuadModel> readCut(const ConsolidateRequest& request, const std::string& file)
{
    QuadCounts quads;
    std::optional<KeptQuads> kept;
    std::function<void(osg::Node&)> cut;
    if (request.diagonal)
    {
        kept.emplace();
        cut = [&](osg::Node& node) { quads = cutQuads(node, *request.diagonal); };
    }
    auto model = read(file, request.models.limits, cut);
    if (!model) return model.error();
    return QuadModel{std::move(*model), quads};
}

/// Every count of a report, by name; zeros are left out.
std::vector<std::pair<const char*, std::size_t>> countsOf(const core::ConsolidateReport& r)
{
    std::vector<std::pair<const char*, std::size_t>> counts = {
        {"positions welded", r.weldedPositions},
        {"degenerate faces removed", r.degenerateFaces},
        {"duplicate faces removed", r.duplicates.removed},
        {"of these hidden by another material", r.duplicates.hidden},
        {"faces back to back made one of two sides", r.duplicates.backToBack},
        {"pairs back to back of different look kept", r.duplicates.kept},
        {"T-vertices inserted", r.tVertices.inserted},
        {"vertices stitched", r.tVertices.stitched},
        {"open slivers removed", r.tVertices.slivers},
        {"vertices moved towards an edge", r.tVertices.moved},
        {"patches in doubt about their front", r.orientation.doubtful},
        {"of these judged by few rays or none, since too many faces lie over each other",
         r.orientation.unjudged},
        {"faces turned", r.orientation.turnedFaces},
        {"edges between faces that do not agree, cut", r.splitEdges.disagreeing},
        {"edges of more than two faces, split", r.splitEdges.crowded},
        {"positions doubled by that", r.splitEdges.copies},
        {"faces left as they were, since repairs made a count worse", r.facesAsTheyWere},
        {"closed groups", r.insideOut.closedGroups},
        {"of these inside out, turned", r.insideOut.turnedGroups},
        {"of these cavities", r.insideOut.cavities},
        {"faces given normals", r.facesGivenNormals},
        {"attributes dropped that no state looks at", r.wedges.unseenAttributes},
        {"needless wedges merged", r.wedges.merged}};
    std::erase_if(counts, [](const auto& count) { return count.second == 0; });
    return counts;
}

foundation::Outcome write(const ConsolidateRequest& request, const std::string& name,
                          const core::Mesh& before, const ImportedModel& model)
{
    if (!request.outputFolder.empty())
        if (const auto done = writeModel(model, request.outputFolder / (name + '.' + request.format),
                                         stripsAsAsked(request.strips));
            !done)
            return done.error();
    if (request.dumpFolder.empty()) return foundation::success();
    if (const auto done = writePlain(before, request.dumpFolder / (name + ".before.obj")); !done)
        return done.error();
    return writePlain(model.mesh, request.dumpFolder / (name + ".after.obj"));
}

void printReport(const std::string& file, const Json& row, const core::ConsolidateReport& report)
{
    std::cout << file << '\n';
    for (const auto& [key, before] : row["before"].items())
        std::cout << "  " << key << ": " << before << " -> " << row["after"][key] << '\n';
    std::cout << "  surface change: " << row["surfaceChangePercent"]
              << " % of the diagonal\n  ms: " << row["ms"] << '\n';
    if (row.contains("quads")) std::cout << "  quads: " << row["quads"].dump() << '\n';
    for (const auto& [what, count] : countsOf(report))
        std::cout << "  " << what << ": " << count << '\n';
}

foundation::Result<Json> consolidateFile(const ConsolidateRequest& request, OutputNames& names,
                                         const std::string& file)
{
    auto cut = readCut(request, file);
    if (!cut) return cut.error();
    ReadModel* const model = &cut->model;
    core::Mesh& mesh = model->imported.mesh;
    const core::Mesh before = mesh;
    core::ConsolidateReport report;
    const double ms = millisecondsOf([&] { report = core::consolidate(mesh, request.options); });
    const double diagonal = core::diagonalOf(before);
    const double change = core::surfaceChange(before, mesh).largest;
    Json row{{"model", file},
             {"before", tableOf(core::countMesh(before))},
             {"after", tableOf(core::countMesh(mesh))},
             {"surfaceChangePercent", diagonal > 0.0 ? 100.0 * change / diagonal : 0.0},
             {"trianglesDropped", report.facesDropped()},
             {"ms", ms}};
    if (request.diagonal)
        row["quads"] = {{"cut", cut->quads.cut}, {"turned", cut->quads.turned}, {"left", cut->quads.left}};
    orderAsAsked(mesh, request.order);
    if (const auto written = write(request, names.nameFor(file), before, model->imported); !written)
        return written.error();
    printReport(file, row, report);
    addLosses(row, *model);
    printLosses(row);
    return row;
}

foundation::Result<terminal::Report> consolidateModels(const ConsolidateRequest& request)
{
    for (const auto& folder : {request.outputFolder, request.dumpFolder})
        if (!folder.empty())
            if (const auto made = makeFolder(folder); !made) return made.error();
    OutputNames names;
    return forEachModel(request.models.files,
                        [&](const std::string& file) { return consolidateFile(request, names, file); });
}

} // namespace

void addConsolidate(CLI::App& app, Chosen& chosen)
{
    const auto request = std::make_shared<ConsolidateRequest>();
    CLI::App* command = app.add_subcommand(
        "consolidate",
        "repair each model: weld, close cracks, remove degenerate faces, orient, merge needless splits");
    addModelOptions(*command, request->models, chosen.jsonFile);
    command->add_option("--output", request->outputFolder, "folder for the repaired models");
    command->add_option("--format", request->format, "format of the models (osgb)")
        ->check(CLI::IsMember({"osgb", "osgt", "ive"}));
    command->add_option("--order", request->order, "order of the faces (library)")
        ->transform(terminal::named(kFaceOrders));
    command
        ->add_option(
            "--strips", request->strips,
            "sends the triangles of each geometry as one strip: sgi, dual (of the dual graph); or none "
            "(none)")
        ->transform(terminal::named(kStrips));
    command->add_option("--dump", request->dumpFolder,
                        "folder for positions and faces before and after, as plain .obj");
    command
        ->add_option(
            "--quad-diagonal", request->diagonal,
            "diagonal along which quads are cut: between corners of the nearest colours, normals or heights; "
            "height-difference: of the most different heights; angle: largest angle between the triangles; "
            "areas: most similar areas (as OpenGL draws them)")
        ->transform(terminal::named(kDiagonals));
    core::ConsolidateOptions& options = request->options;
    command
        ->add_option("--weld", options.weldTolerance,
                     "positions nearer than this share of the diagonal become one (1e-6)")
        ->check(terminal::between(0.0, 0.1));
    command
        ->add_option("--stitch", options.stitchTolerance,
                     "vertices nearer to an edge than this share of the diagonal are put into it (1.01e-5)")
        ->check(terminal::between(0.0, 0.1));
    command
        ->add_option("--crease", options.creaseAngleDeg,
                     "edges sharper than this stay sharp in normals that are made, degrees (45)")
        ->check(terminal::between(0.0, 180.0));
    command->add_flag("!--as-oriented", options.orient, "turn no faces");
    command->add_flag(
        "!--keep-unseen", options.wedges.dropUnseen,
        "keep attributes that the state does not use, such as coordinates of a missing texture");
    command->callback([request, &chosen]
                      { chosen.work = [request] { return consolidateModels(*request); }; });
}

} // namespace pmtool
