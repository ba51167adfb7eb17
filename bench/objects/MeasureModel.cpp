// SPDX-License-Identifier: Apache-2.0
#include "MeasureModel.h"

#include <algorithm>
#include <iostream>

#include <osgPMObjects/core/selection/LevelTable.h>
#include <osgPMObjects/core/simplify/Simplifiable.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include <osgPMObjects/ExportNode>
#include <osgPMObjects/ReadModel>

#include "RatePlot.h"

namespace objectbench
{

using namespace osgPMObjects;
using Json = Race::Json;

namespace
{

/// Returns the means over all levels, by contestant: time, invocations, and frame rate as a multiple of
/// the first one's (plain VIPM's).
Json summaryOf(const Json& rows, const std::vector<Contestant>& contestants)
{
    Json summary;
    for (const Contestant& contestant : contestants)
    {
        double ms = 0.0, invocations = 0.0, rate = 0.0;
        for (const Json& row : rows)
        {
            ms += row[contestant.name]["ms"].get<double>();
            invocations += row[contestant.name]["invocations"].get<double>();
            rate +=
                row[contestants.front().name]["ms"].get<double>() / row[contestant.name]["ms"].get<double>();
        }
        const auto count = static_cast<double>(rows.size());
        summary[contestant.name] = {{"meanMs", ms / count},
                                    {"meanInvocations", invocations / count},
                                    {"meanRateOfPlain", rate / count}};
    }
    return summary;
}

std::vector<Contestant> contestantsFor(const Request& request, const core::Mesh& mesh,
                                       const core::CollapseSequence& sequence)
{
    if (request.asStrips) return stripContestantsOf(mesh, sequence);
    return request.movingPercent > 0.0 ? movingContestantsOf(mesh, sequence) : contestantsOf(mesh, sequence);
}

} // namespace

foundation::Result<Json> measureModel(const std::string& file, const Request& request, Race& race,
                                      std::vector<std::string>& plots)
{
    const auto node = readModelNode(file);
    if (!node) return node.error();
    auto imported = importNode(**node, file);
    if (!imported) return imported.error();
    core::Mesh& mesh = imported->mesh;
    core::makeSimplifiable(mesh);
    if (mesh.faces.empty()) return foundation::Error{file, "has no triangles", "give a model with surfaces"};
    const core::CollapseSequence sequence = core::simplify(mesh);
    const auto most = static_cast<std::uint32_t>(sequence.steps.size());
    std::vector<std::uint32_t> levels;
    for (int i = 0; i < request.levels; ++i)
        levels.push_back(most / static_cast<std::uint32_t>(request.levels) * static_cast<std::uint32_t>(i));
    std::vector<Contestant> contestants = contestantsFor(request, mesh, sequence);
    const osg::BoundingSphere ball = contestants.front().nodeAt(0)->getBound();
    Json model = {{"model", std::filesystem::path(file).filename().string()},
                  {"triangles", mesh.faces.size()},
                  {"vertices", mesh.wedgeCount()}};
    for (const int lights : request.lights)
    {
        Json rows = race.run(contestants, levels, most, lights, ball);
        const core::LevelTable table = core::LevelTable::of(mesh, sequence);
        for (Json& row : rows)
            row["faces"] = table.faces[std::min(row["steps"].get<std::uint32_t>(), table.mostSteps())];
        plots.push_back(ratePlot(model["model"].get<std::string>(), lights, rows, contestants));
        const Json summary = summaryOf(rows, contestants);
        std::cout << model["model"].get<std::string>() << ", " << lights << " lights: " << summary.dump()
                  << '\n';
        model["lights"].push_back({{"count", lights}, {"means", summary}, {"levels", rows}});
    }
    return model;
}

} // namespace objectbench
