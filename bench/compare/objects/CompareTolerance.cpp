// SPDX-License-Identifier: Apache-2.0
#include <iomanip>
#include <iostream>
#include <memory>

#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgPMObjects/core/progressive/MeasureLevels.h>
#include <osgPMObjects/core/simplify/SimplificationError.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include <osgPMObjects/MaterialLooks>

#include "compare/objects/ChosenLevel.h"
#include "compare/objects/Commands.h"
#include "pmtool/Models.h"
#include "pmtool/Timing.h"
#include "terminal/CommandLine.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
using Json = nlohmann::ordered_json;

struct ToleranceRequest
{
    ModelRequest models;
    std::vector<double> acrossPx{30.0, 300.0};
    std::uint32_t points = 60'000;
    double mostRatio = 0.0; ///< 0: any
};

/// A model as a progressive mesh, with a meter whose samples are others than those of its ladder.
class ToleranceSubject
{
public:
    ToleranceSubject(const ImportedModel& imported, std::size_t points)
        : _progressive(progressiveOf(imported)),
          _ladderMs(millisecondsOf([this] { core::measureLevels(_progressive); })),
          _table(core::LevelTable::of(_progressive)),
          _original(core::meshAfter(_progressive, 0)),
          _meter(_original, points),
          _diagonal(core::extentOfFaces(_original).diagonal())
    {
    }

    Json row(double acrossPx) const
    {
        const ChosenLevel shown = levelShownAt(_table, 0.5 * _diagonal, acrossPx);
        core::LevelTable estimates = _table;
        estimates.measured = {};
        const std::uint32_t fewest = fewestWithin(shown);
        return {{"acrossPx", acrossPx},
                {"tolerance", shown.tolerance},
                {"estimates", levelShownAt(estimates, 0.5 * _diagonal, acrossPx).faces},
                {"shown", shown.faces},
                {"fewest", fewest},
                {"ratio", double(shown.faces) / fewest}};
    }

    double ladderMs() const { return _ladderMs; }
    std::size_t ladderLevels() const { return _progressive.ladder.size(); }

private:
    static core::ProgressiveMesh progressiveOf(const ImportedModel& imported)
    {
        core::SimplifySettings settings;
        settings.materialColours = materialColours(imported.mesh, imported.states);
        return core::buildProgressiveMesh(imported.mesh, core::simplify(imported.mesh, settings),
                                          {.arrangement = core::Arrangement::plain});
    }

    /// The fewest triangles of any level, of a finer ladder than that of the errors, that keeps the tolerance
    /// of a shown one. Levels of less than a third of its triangles are not looked at.
    std::uint32_t fewestWithin(const ChosenLevel& shown) const
    {
        constexpr double kRatio = 1.05;
        const std::vector<std::uint32_t> steps = core::ladderSteps(_table.faces, kRatio);
        for (auto level = steps.rbegin(); level != steps.rend(); ++level)
        {
            const std::uint32_t faces = _table.faces[*level];
            if (3 * faces < shown.faces) continue;
            if (faces >= shown.faces) break;
            const double percent = _meter.measure(core::meshAfter(_progressive, *level)).maxPercent;
            if (0.01 * percent * _diagonal <= shown.tolerance) return faces;
        }
        return shown.faces;
    }

    core::ProgressiveMesh _progressive;
    double _ladderMs;
    core::LevelTable _table;
    core::Mesh _original;
    core::SimplificationMeter _meter;
    double _diagonal;
};

foundation::Result<Json> compareModelTolerances(const std::string& file, const ToleranceRequest& request)
{
    const auto model = readClean(file, request.models.limits);
    if (!model) return model.error();
    const ImportedModel& imported = model->read.imported;
    const ToleranceSubject subject(imported, request.points);
    Json row{{"model", file},
             {"triangles", imported.mesh.faces.size()},
             {"ladderLevels", subject.ladderLevels()},
             {"ladderMs", subject.ladderMs()},
             {"results", Json::array()}};
    std::cout << file << ": " << imported.mesh.faces.size() << " triangles, " << subject.ladderLevels()
              << " levels measured in " << std::lround(subject.ladderMs())
              << " ms\n  pixels  estimates     shown    fewest   ratio\n";
    for (const double acrossPx : request.acrossPx)
    {
        const Json result = subject.row(acrossPx);
        std::cout << std::setw(8) << acrossPx << std::setw(11) << result["estimates"].get<std::uint32_t>()
                  << std::setw(10) << result["shown"].get<std::uint32_t>() << std::setw(10)
                  << result["fewest"].get<std::uint32_t>() << std::fixed << std::setprecision(2)
                  << std::setw(8) << result["ratio"].get<double>() << std::defaultfloat << std::endl;
        row["results"].push_back(result);
    }
    return row;
}

/// Marks the report as unsound, with a line each, for models that show more than `most` times the fewest
/// triangles.
void judge(terminal::Report& report, double most)
{
    for (const Json& model : report.json["models"])
        for (const Json& result : model["results"])
        {
            if (most == 0.0 || result["ratio"].get<double>() <= most) continue;
            report.sound = false;
            std::cerr << kComparer << ": " << model["model"].get<std::string>() << ": shows "
                      << result["ratio"].get<double>() << " times the fewest triangles, " << most
                      << " are allowed; measure a finer ladder\n";
        }
}

} // namespace

void addCompareTolerance(CLI::App& app, Chosen& chosen)
{
    const auto request = std::make_shared<ToleranceRequest>();
    CLI::App* sub = app.add_subcommand(
        "tolerance",
        "triangles that progressive objects show at a tolerance of a pixel, and the fewest that keep it");
    addModelOptions(*sub, request->models, chosen.jsonFile);
    sub->add_option("--across", request->acrossPx, "pixels that the object is across (30,300)")
        ->delimiter(',')
        ->check(terminal::between(1.0, 100'000.0));
    sub->add_option("--points", request->points, "points on each surface to measure by (60000)")
        ->check(terminal::between(100, 10'000'000));
    sub->add_option("--most-ratio", request->mostRatio,
                    "fail where a model shows more than so many times the fewest triangles (any)")
        ->check(terminal::between(1.0, 1000.0));
    sub->callback(
        [&chosen, request]
        {
            chosen.work = [request]
            {
                auto report = forEachModel(
                    request->models.files,
                    [&](const std::string& file) { return compareModelTolerances(file, *request); },
                    kComparer);
                if (report) judge(*report, request->mostRatio);
                return report;
            };
        });
}

} // namespace pmtool
