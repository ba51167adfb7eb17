// SPDX-License-Identifier: Apache-2.0
// object_frame_bench: measures frames of a lit model at its levels, by the order of its faces.
#include <foundation/WholeFile.h>

#include "MeasureModel.h"
#include "RatePlot.h"
#include "StripTable.h"
#include "terminal/CommandLine.h"
#include "terminal/Terminal.h"

namespace
{

using namespace objectbench;

int run(const Request& request)
{
    if (const auto writable = foundation::checkWritable(request.jsonFile); !writable)
        return terminal::fail("object_frame_bench", writable.error());
    const auto viewer = osgOffscreen::OffscreenViewer::create(request.picture);
    if (!viewer) return terminal::fail("object_frame_bench", viewer.error());
    Race race(**viewer, request);
    std::vector<std::string> plots;
    Race::Json report = {{"backend", std::string(osgOffscreen::backendName(request.picture.backend))},
                         {"widthPx", request.picture.widthPx},
                         {"heightPx", request.picture.heightPx}};
    for (const std::string& file : request.files)
    {
        auto model = measureModel(file, request, race, plots);
        if (!model) return terminal::fail("object_frame_bench", model.error());
        report["models"].push_back(std::move(*model));
    }
    if (!request.plotFile.empty())
    {
        const auto drawn = foundation::writeWholeFile(request.plotFile, plotsFile(plots));
        if (!drawn) return terminal::fail("object_frame_bench", drawn.error());
    }
    if (!request.markdownFile.empty())
    {
        const auto told = foundation::writeWholeFile(request.markdownFile, stripTable(report));
        if (!told) return terminal::fail("object_frame_bench", told.error());
    }
    if (request.jsonFile.empty()) return terminal::kDone;
    const auto written = foundation::writeWholeFile(request.jsonFile, report.dump(1) + "\n");
    return written ? terminal::kDone : terminal::fail("object_frame_bench", written.error());
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Measures lit models at their levels offscreen, by the order of their faces.",
                 "object_frame_bench");
    Request request;
    app.add_option("MODEL", request.files, "files that OpenSceneGraph reads, .gltf, .glb")->required();
    app.add_option("--lights", request.lights, "number of lights in the vertex shader")
        ->check(CLI::Range(1, 200));
    app.add_option("--levels", request.levels)->check(CLI::Range(1, 1000));
    app.add_option("--repeats", request.repeats, "frames of each level; the fastest counts")
        ->check(CLI::Range(1, 10000));
    app.add_option("--moving", request.movingPercent,
                   "per cent of all steps by which the level changes from frame to frame, to and fro (0); "
                   "more numbers of tswaps run")
        ->check(CLI::Range(0.0, 50.0));
    CLI::Option* strips =
        app.add_flag(
               "--strips", request.asStrips,
               "instead: static triangles, in meshoptimizer's order and along Hilbert's curve, and strips")
            ->excludes("--moving");
    app.add_option("--markdown", request.markdownFile,
                   "with --strips: also write the finest levels to this file, as a table")
        ->needs(strips);
    std::string backend{osgOffscreen::backendName(request.picture.backend)};
    app.add_option("--backend", backend, "osmesa or egl");
    app.add_option("--width", request.picture.widthPx)->check(CLI::Range(16, 4096));
    app.add_option("--height", request.picture.heightPx)->check(CLI::Range(16, 4096));
    app.add_option("--plot", request.plotFile, "SVG with frames per second against faces")->type_name("FILE");
    app.add_option("--json", request.jsonFile, "also write the table to this file");
    if (const auto ends = terminal::parse(app, argc, argv)) return *ends;
    const auto parsed = osgOffscreen::parseBackend(backend);
    if (!parsed) return terminal::fail("object_frame_bench", parsed.error());
    request.picture.backend = *parsed;
    return run(request);
}
