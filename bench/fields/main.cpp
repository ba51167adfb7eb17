// SPDX-License-Identifier: Apache-2.0
// field_bench: a landscape of thousands of objects, as a progressive field, as osg::LODs of five levels, and in full detail:
// times, triangles, memory and error of the picture, in one run.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>

#include <glm/gtc/matrix_transform.hpp>
#include <malloc.h>
#include <nlohmann/json.hpp>

#include <viewlod/ViewState.h>
#include <viewlod/WholeFile.h>

#include <osgOffscreen/OffscreenViewer>
#include <osgOffscreen/PngFile>

#include "Contestants.h"
#include "Percentile.h"
#include "models/Plain.h"
#include "objects/PipelineCount.h"
#include "terminal/CommandLine.h"
#include "terminal/Terminal.h"

namespace
{

using namespace fieldbench;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

struct Request
{
    std::uint32_t count = 10000;
    double spacingM = 18.0, trianglePx = 12.0, lodTrianglePx = 12.0;
    int frames = 24, compared = 2;
    osgOffscreen::OffscreenSettings picture{.widthPx = 960, .heightPx = 540};
    std::vector<std::string> contestants{"ours", "lod", "full"};
    std::filesystem::path jsonFile, pictures;

    bool has(const std::string& name) const
    {
        return std::find(contestants.begin(), contestants.end(), name) != contestants.end();
    }
};

constexpr double kHighDeg = 40.0, kFrameS = 0.04;

double milliseconds(Clock::time_point since)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - since).count();
}

/// By everything in this process, the software renderer among it.
double megabytesInUse()
{
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd) / 1e6;
}

/// Eyes along two paths over the landscape: at a driver's height, and 120 m up, looking down a little.
struct Path
{
    const char* name;
    double heightM, pitch, stepM;
};
constexpr Path kPaths[] = {{"drive", 2.0, 0.0, 0.6}, {"flight", 120.0, -0.25, 2.0}};

class Field
{
public:
    Field(osgOffscreen::OffscreenViewer& viewer, const Request& request)
        : _viewer(viewer),
          _count(viewer.camera(), objectbench::PipelineCount::kVertexShaderInvocations),
          _request(request),
          _air(new osgTerrainROAM::Atmosphere)
    {
        viewer.camera().setProjectionMatrixAsPerspective(
            kHighDeg, static_cast<double>(request.picture.widthPx) / request.picture.heightPx, 0.5, 2e4);
    }

    /// The times of a path's frames, or, of none, those of the pictures that are compared.
    Json fly(const std::string& name, osg::Node& objects, const Path& path, int frames)
    {
        _viewer.viewer().setSceneData(onPlain(objects, *_air));
        std::vector<double> times, invocations;
        frameMs(path, 0); // compiles
        for (int i = 0; i < frames; ++i)
            times.push_back(frameMs(path, i));
        for (int i = 0; i < _request.compared; ++i)
        {
            const int at = i * (_request.frames - 1) / std::max(1, _request.compared - 1);
            look(path, at);
            _count.setCounting(false);
            const auto begin = Clock::now();
            const auto picture = _viewer.picture(kFrameS * at);
            if (frames == 0) times.push_back(milliseconds(begin));
            _count.setCounting(true);
            _viewer.frame(kFrameS * at);
            _count.setCounting(false);
            invocations.push_back(static_cast<double>(_count.counted()));
            keep(*picture, name + "-" + path.name + "-" + std::to_string(i));
            _pictures[name + path.name].push_back(picture);
        }
        double sum = 0.0;
        for (const double i : invocations)
            sum += i;
        return {{"medianMs", roambench::percentile(times, 0.5)},
                {"p99Ms", roambench::percentile(times, 0.99)},
                {"invocations", sum / static_cast<double>(invocations.size())}};
    }

    /// Root of the mean square of the levels by which two contestants' pictures differ.
    double difference(const std::string& name, const std::string& other, const Path& path)
    {
        double sum = 0.0, values = 0.0;
        for (int i = 0; i < _request.compared; ++i)
        {
            const osg::Image& a = *_pictures[name + path.name][i];
            const osg::Image& b = *_pictures[other + path.name][i];
            for (unsigned at = 0; at < a.getTotalSizeInBytes(); ++at, ++values)
                sum += std::pow(static_cast<double>(a.data()[at]) - b.data()[at], 2.0);
        }
        return std::sqrt(sum / values);
    }

private:
    double frameMs(const Path& path, int frame)
    {
        look(path, frame);
        const auto begin = Clock::now();
        _viewer.frame(kFrameS * frame);
        return milliseconds(begin);
    }

    void look(const Path& path, int frame)
    {
        const osg::Vec3d eye(4.0, -0.3 * 1000.0 + path.stepM * frame, path.heightM);
        const osg::Vec3d along(0.1, 1.0, path.pitch);
        _viewer.camera().setViewMatrixAsLookAt(eye, eye + along, {0.0, 0.0, 1.0});
    }

    void keep(const osg::Image& picture, const std::string& name) const
    {
        if (_request.pictures.empty()) return;
        const auto written = osgOffscreen::writePng(picture, _request.pictures / (name + ".png"));
        if (!written) std::cerr << written.error().message() << '\n';
    }

    osgOffscreen::OffscreenViewer& _viewer;
    objectbench::PipelineCount _count;
    const Request& _request;
    osg::ref_ptr<osgTerrainROAM::Atmosphere> _air;
    std::map<std::string, std::vector<osg::ref_ptr<osg::Image>>> _pictures;
};

int run(const Request& request)
{
    if (const auto writable = viewlod::checkWritable(request.jsonFile); !writable)
        return terminal::fail("field_bench", writable.error());
    const auto viewer = osgOffscreen::OffscreenViewer::create(request.picture);
    if (!viewer) return terminal::fail("field_bench", viewer.error());
    const auto start = Clock::now();
    const Shapes shapes = landscapeShapes();
    const auto instances =
        scattered(request.count, static_cast<std::uint32_t>(shapes.size()), request.spacingM);
    Json report = {{"instances", request.count},
                   {"kinds", shapes.size()},
                   {"trianglePx", request.trianglePx},
                   {"lodTrianglePx", request.lodTrianglePx},
                   {"shapesS", 1e-3 * milliseconds(start)}};
    const viewlod::ViewState view = viewlod::ViewState::fromMatrices(
        glm::dmat4(1.0),
        glm::perspective(glm::radians(kHighDeg),
                         static_cast<double>(request.picture.widthPx) / request.picture.heightPx, 0.5, 2e4),
        request.picture.widthPx, request.picture.heightPx);

    Field field(**viewer, request);
    const auto race = [&](const std::string& name, const auto& make, int frames)
    {
        if (!request.has(name)) return;
        const double before = megabytesInUse();
        const auto began = Clock::now();
        const osg::ref_ptr<osg::Node> objects = make();
        // What the scene graph takes; the renderer's own memory is that of the largest frame so far.
        Json row = {{"buildS", 1e-3 * milliseconds(began)}, {"graphMegabytes", megabytesInUse() - before}};
        for (const Path& path : kPaths)
            row[path.name] = field.fly(name, *objects, path, frames);
        if (const auto* const ours = dynamic_cast<osgPMObjects::ProgressiveField*>(objects.get()))
            for (const auto& statistics : ours->statistics())
                row["last"] = {
                    {"visible", statistics.visible},
                    {"cullMs", statistics.cullMs},
                    {"cullNsPerVisible", 1e6 * statistics.cullMs / std::max(1u, statistics.visible)},
                    {"triangles", statistics.triangles},
                    {"drawCalls", statistics.drawCalls}};
        (*viewer)->viewer().setSceneData(new osg::Group);
        std::cout << name << ": " << row.dump() << std::endl;
        report[name] = row;
    };
    race(
        "ours", [&] { return progressiveField(shapes, instances, request.trianglePx); }, request.frames);
    race(
        "lod", [&] { return discreteLods(shapes, instances, request.lodTrianglePx, view.pixelsPerTangent); },
        request.frames);
    race(
        "full", [&] { return fullDetail(shapes, instances); }, 0);
    for (const char* const name : {"ours", "lod"})
        for (const Path& path : kPaths)
        {
            if (!request.has(name) || !request.has("full")) continue;
            const double rms = field.difference(name, "full", path);
            report[name][path.name]["rmsToFull"] = rms;
            std::cout << name << ' ' << path.name << ": differs from full detail by " << rms
                      << " levels (rms)\n";
        }
    if (request.jsonFile.empty()) return terminal::kDone;
    const auto written = viewlod::writeWholeFile(request.jsonFile, report.dump(1) + "\n");
    return written ? terminal::kDone : terminal::fail("field_bench", written.error());
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Draws a landscape of many objects offscreen, in three ways.", "field_bench");
    Request request;
    app.add_option("--count", request.count, "instances")->check(CLI::Range(1u, 10000000u));
    app.add_option("--spacing", request.spacingM, "metres")->check(terminal::between(1.0, 1000.0));
    app.add_option("--triangle", request.trianglePx, "pixels that a face covers, of the field")
        ->check(terminal::between(0.1, 1000.0));
    app.add_option("--lod-triangle", request.lodTrianglePx, "the same of the osg::LODs")
        ->check(terminal::between(0.1, 1000.0));
    app.add_option("--frames", request.frames)->check(CLI::Range(3, 10000));
    app.add_option("--compared", request.compared,
                   "frames of each path whose pictures are compared with full detail")
        ->check(CLI::Range(1, 100));
    app.add_option("--contestants", request.contestants, "of ours, lod, full")
        ->check(CLI::IsMember({"ours", "lod", "full"}));
    app.add_option("--json", request.jsonFile, "write the table there, too");
    app.add_option("--pictures", request.pictures, "folder for the pictures that were compared");
    if (const auto ends = terminal::parse(app, argc, argv)) return *ends;
    return run(request);
}
