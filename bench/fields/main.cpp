// SPDX-License-Identifier: Apache-2.0
// field_bench: measures a landscape of thousands of objects as a progressive field, as osg::LODs of five
// levels, and in full detail: times, triangles, memory and error of the picture, in one run.
#include <foundation/WholeFile.h>

#include "Race.h"
#include "Times.h"
#include "terminal/CommandLine.h"
#include "terminal/Terminal.h"

namespace
{

using namespace fieldbench;

int run(const Request& request)
{
    if (const auto writable = foundation::checkWritable(request.jsonFile); !writable)
        return terminal::fail("field_bench", writable.error());
    const auto viewer = osgOffscreen::OffscreenViewer::create(request.picture);
    if (!viewer) return terminal::fail("field_bench", viewer.error());
    const auto start = Clock::now();
    const Shapes shapes = landscapeShapes();
    const auto instances =
        scattered(request.count, static_cast<std::uint32_t>(shapes.size()), request.spacingM);
    Race::Json report = {
        {"instances", request.count}, {"kinds", shapes.size()}, {"shapesS", 1e-3 * milliseconds(start)}};
    Stage stage(**viewer, request);
    report.update(Race(stage, request).run(shapes, instances));
    if (request.jsonFile.empty()) return terminal::kDone;
    const auto written = foundation::writeWholeFile(request.jsonFile, report.dump(1) + "\n");
    return written ? terminal::kDone : terminal::fail("field_bench", written.error());
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Measures a landscape of many objects offscreen, drawn in three ways.", "field_bench");
    Request request;
    app.add_option("--count", request.count, "instances")->check(CLI::Range(1u, 10000000u));
    app.add_option("--spacing", request.spacingM, "metres")->check(terminal::between(1.0, 1000.0));
    app.add_option("--triangle", request.trianglesPx,
                   "pixels that a face of the field covers; one flight for each value")
        ->check(terminal::between(0.1, 1000.0));
    app.add_option("--lod-triangle", request.lodTrianglesPx, "pixels that a face of the osg::LODs covers")
        ->check(terminal::between(0.1, 1000.0));
    app.add_option("--frames", request.frames)->check(CLI::Range(3, 10000));
    app.add_option("--compared", request.compared, "frames of each path that are compared with full detail")
        ->check(CLI::Range(1, 100));
    app.add_option("--contestants", request.contestants, "some of ours, lod, full")
        ->check(CLI::IsMember({"ours", "lod", "full"}));
    app.add_option("--json", request.jsonFile, "also write the table to this file");
    app.add_option("--pictures", request.pictures, "folder for the compared images");
    if (const auto ends = terminal::parse(app, argc, argv)) return *ends;
    return run(request);
}
