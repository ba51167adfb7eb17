// SPDX-License-Identifier: Apache-2.0
// object_frame_bench: what a frame of a lit model takes at its levels, by the order of its faces.
#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <iostream>

#include <nlohmann/json.hpp>

#include <viewlod/WholeFile.h>

#include <osgPMObjects/core/selection/LevelTable.h>
#include <osgPMObjects/core/simplify/Simplifiable.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include <osgOffscreen/OffscreenViewer>
#include <osgPMObjects/ExportNode>
#include <osgPMObjects/ReadModel>

#include "Contestants.h"
#include "PipelineCount.h"
#include "VertexLights.h"
#include "terminal/CommandLine.h"
#include "terminal/Terminal.h"
#include "view/SvgPlot.h"

namespace
{

using namespace objectbench;
using namespace osgPMObjects;
using Json = nlohmann::ordered_json;

struct Request
{
    std::vector<std::string> files;
    std::vector<int> lights{32, 96};
    int levels = 10, repeats = 15;
    osgOffscreen::OffscreenSettings picture{.widthPx = 640, .heightPx = 480};
    std::filesystem::path jsonFile, plotFile;
};

/// Draws contestants in turns, and keeps the least time of each: other programs only ever add to it.
class Race
{
public:
    Race(osgOffscreen::OffscreenViewer& viewer, const Request& request)
        : _viewer(viewer), _count(viewer.camera(), PipelineCount::kVertexShaderInvocations), _request(request)
    {
    }

    Json run(std::vector<Contestant>& contestants, const std::vector<std::uint32_t>& levels, int lights,
             const osg::BoundingSphere& ball)
    {
        look(ball);
        const osg::ref_ptr<osg::Group> scene = new osg::Group;
        scene->setStateSet(vertexLights(lights, ball));
        _viewer.viewer().setSceneData(scene);
        Json rows = Json::array();
        for (const std::uint32_t steps : levels)
        {
            std::vector<double> least(contestants.size(), 1e30);
            std::vector<std::uint64_t> invocations(contestants.size());
            std::vector<osg::ref_ptr<osg::Node>> nodes;
            for (const Contestant& contestant : contestants)
                nodes.push_back(contestant.nodeAt(steps));
            for (int repeat = -1; repeat < _request.repeats; ++repeat)
                for (std::size_t i = 0; i < contestants.size(); ++i)
                {
                    scene->removeChildren(0, scene->getNumChildren());
                    scene->addChild(nodes[i]);
                    _count.setCounting(repeat < 0);
                    const double ms = frameMs();
                    if (repeat < 0)
                        invocations[i] = _count.counted();
                    else
                        least[i] = std::min(least[i], ms);
                }
            Json row = {{"steps", steps}};
            for (std::size_t i = 0; i < contestants.size(); ++i)
                row[contestants[i].name] = {{"ms", least[i]}, {"invocations", invocations[i]}};
            rows.push_back(std::move(row));
        }
        return rows;
    }

private:
    double frameMs()
    {
        const auto start = std::chrono::steady_clock::now();
        _viewer.frame(0.0);
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    }

    void look(const osg::BoundingSphere& ball)
    {
        const double away = ball.radius() / std::sin(osg::DegreesToRadians(15.0));
        const osg::Vec3d from = osg::Vec3d(ball.center()) + osg::Vec3d(0.66, -0.66, 0.36) * away;
        _viewer.camera().setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
        _viewer.camera().setProjectionMatrixAsPerspective(
            30.0, static_cast<double>(_request.picture.widthPx) / _request.picture.heightPx,
            away - 1.1 * ball.radius(), away + 1.1 * ball.radius());
        _viewer.camera().setViewMatrixAsLookAt(from, ball.center(), {0.0, 0.0, 1.0});
    }

    osgOffscreen::OffscreenViewer& _viewer;
    PipelineCount _count;
    const Request& _request;
};

/// Means over levels of each contestant: time, invocations, and how many times the frame rate of plain VIPM.
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
            rate += row["plain"]["ms"].get<double>() / row[contestant.name]["ms"].get<double>();
        }
        const auto count = static_cast<double>(rows.size());
        summary[contestant.name] = {{"meanMs", ms / count},
                                    {"meanInvocations", invocations / count},
                                    {"meanRateOfPlain", rate / count}};
    }
    return summary;
}

/// Paper 004, figure 17: frames per second against faces, for each contestant.
std::string plotOf(const std::string& model, int lights, const Json& rows,
                   const std::vector<Contestant>& contestants)
{
    const std::array<const char*, 4> colours{"#c0392b", "#d68910", "#1f6fb2", "#5d6d7e"};
    trainer::Plot plot{model + ", " + std::to_string(lights) + " lights: frames per second", "faces", {}, {}};
    for (auto row = rows.rbegin(); row != rows.rend(); ++row)
        plot.x.push_back((*row)["faces"].get<double>());
    for (std::size_t i = 0; i < contestants.size(); ++i)
    {
        trainer::PlotSeries series{contestants[i].name, colours[i % colours.size()], {}};
        for (auto row = rows.rbegin(); row != rows.rend(); ++row)
            series.values.push_back(1000.0 / (*row)[contestants[i].name]["ms"].get<double>());
        plot.series.push_back(std::move(series));
    }
    return trainer::svgPlot(plot);
}

/// Plots one below the other, as a file of their own.
std::string svgOf(const std::vector<std::string>& plots)
{
    constexpr int kWidth = 720, kHeight = 220;
    const std::string height = std::to_string(kHeight * static_cast<int>(plots.size()));
    std::string svg =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"720\" height=\"" + height +
        "\">\n<style>text { font: 11px sans-serif } .grid { stroke: #dde3e8 } polyline { stroke-width: "
        "1.4 }</style>\n<rect width=\"720\" height=\"" +
        height + "\" fill=\"white\"/>\n";
    for (std::size_t i = 0; i < plots.size(); ++i)
        svg += "<svg y=\"" + std::to_string(kHeight * static_cast<int>(i)) + "\" width=\"" +
               std::to_string(kWidth) + "\" height=\"" + std::to_string(kHeight) + "\">\n" + plots[i] +
               "</svg>\n";
    return svg + "</svg>\n";
}

viewlod::Result<Json> measure(const std::string& file, const Request& request, Race& race,
                              std::vector<std::string>& plots)
{
    const auto node = readModelNode(file);
    if (!node) return node.error();
    auto imported = importNode(**node, file);
    if (!imported) return imported.error();
    core::Mesh& mesh = imported->mesh;
    core::makeSimplifiable(mesh);
    if (mesh.faces.empty()) return viewlod::Error{file, "has no triangles", "give a model with surfaces"};
    const core::CollapseSequence sequence = core::simplify(mesh);
    const auto most = static_cast<std::uint32_t>(sequence.steps.size());
    std::vector<std::uint32_t> levels;
    for (int i = 0; i < request.levels; ++i)
        levels.push_back(most / static_cast<std::uint32_t>(request.levels) * static_cast<std::uint32_t>(i));
    std::vector<Contestant> contestants = contestantsOf(mesh, sequence);
    const osg::BoundingSphere ball = contestants.front().nodeAt(0)->getBound();
    Json model = {{"model", std::filesystem::path(file).filename().string()},
                  {"triangles", mesh.faces.size()},
                  {"vertices", mesh.wedgeCount()}};
    for (const int lights : request.lights)
    {
        Json rows = race.run(contestants, levels, lights, ball);
        const core::LevelTable table = core::LevelTable::of(mesh, sequence);
        for (Json& row : rows)
            row["faces"] = table.faces[std::min(row["steps"].get<std::uint32_t>(), table.mostSteps())];
        plots.push_back(plotOf(model["model"].get<std::string>(), lights, rows, contestants));
        const Json summary = summaryOf(rows, contestants);
        std::cout << model["model"].get<std::string>() << ", " << lights << " lights: " << summary.dump()
                  << '\n';
        model["lights"].push_back({{"count", lights}, {"means", summary}, {"levels", rows}});
    }
    return model;
}

int run(const Request& request)
{
    if (const auto writable = viewlod::checkWritable(request.jsonFile); !writable)
        return terminal::fail("object_frame_bench", writable.error());
    const auto viewer = osgOffscreen::OffscreenViewer::create(request.picture);
    if (!viewer) return terminal::fail("object_frame_bench", viewer.error());
    Race race(**viewer, request);
    std::vector<std::string> plots;
    Json report = {{"widthPx", request.picture.widthPx}, {"heightPx", request.picture.heightPx}};
    for (const std::string& file : request.files)
    {
        auto model = measure(file, request, race, plots);
        if (!model) return terminal::fail("object_frame_bench", model.error());
        report["models"].push_back(std::move(*model));
    }
    if (!request.plotFile.empty())
    {
        const auto drawn = viewlod::writeWholeFile(request.plotFile, svgOf(plots));
        if (!drawn) return terminal::fail("object_frame_bench", drawn.error());
    }
    if (request.jsonFile.empty()) return terminal::kDone;
    const auto written = viewlod::writeWholeFile(request.jsonFile, report.dump(1) + "\n");
    return written ? terminal::kDone : terminal::fail("object_frame_bench", written.error());
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Draws lit models offscreen at their levels, by the order of their faces.",
                 "object_frame_bench");
    Request request;
    app.add_option("MODEL", request.files, "files that OpenSceneGraph reads, .gltf, .glb")->required();
    app.add_option("--lights", request.lights, "in the vertex shader")->check(CLI::Range(1, 200));
    app.add_option("--levels", request.levels)->check(CLI::Range(1, 1000));
    app.add_option("--repeats", request.repeats, "frames of each, of which the quickest counts")
        ->check(CLI::Range(1, 10000));
    app.add_option("--width", request.picture.widthPx)->check(CLI::Range(16, 4096));
    app.add_option("--height", request.picture.heightPx)->check(CLI::Range(16, 4096));
    app.add_option("--plot", request.plotFile, "HTML with frames per second against faces")
        ->type_name("FILE");
    app.add_option("--json", request.jsonFile, "write the table there, too");
    if (const auto ends = terminal::parse(app, argc, argv)) return *ends;
    return run(request);
}
