// SPDX-License-Identifier: Apache-2.0
#include "Race.h"

#include <iostream>

#include <glm/gtc/matrix_transform.hpp>
#include <malloc.h>

#include <viewlod/ViewState.h>

#include "Times.h"

namespace fieldbench
{

namespace
{

/// By everything in this process, the software renderer among it.
double megabytesInUse()
{
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd) / 1e6;
}

/// Of the picture.
double pixelsPerTangent(const osgOffscreen::OffscreenSettings& picture)
{
    const double aspect = static_cast<double>(picture.widthPx) / picture.heightPx;
    return viewlod::ViewState::fromMatrices(glm::dmat4(1.0),
                                            glm::perspective(glm::radians(kHighDeg), aspect, 0.5, 2e4),
                                            picture.widthPx, picture.heightPx)
        .pixelsPerTangent;
}

} // namespace

void Race::enter(Json& report, const std::string& name, const Make& make, int frames)
{
    if (!_request.has(name)) return;
    const double before = megabytesInUse();
    const auto began = Clock::now();
    const osg::ref_ptr<osg::Node> objects = make();
    // What the scene graph takes; the renderer's own memory is that of the largest frame so far.
    Json row = {{"buildS", 1e-3 * milliseconds(began)}, {"graphMegabytes", megabytesInUse() - before}};
    for (const Path& path : kPaths)
        row[path.name] = _stage.fly(name, *objects, path, frames);
    if (const auto* const ours = dynamic_cast<osgPMObjects::ProgressiveField*>(objects.get()))
        for (const auto& statistics : ours->statistics())
            row["last"] = {{"visible", statistics.visible},
                           {"cullMs", statistics.cullMs},
                           {"cullNsPerVisible", 1e6 * statistics.cullMs / std::max(1u, statistics.visible)},
                           {"triangles", statistics.triangles},
                           {"drawCalls", statistics.drawCalls}};
    _stage.clear();
    std::cout << name << ": " << row.dump() << std::endl;
    report[name] = row;
}

void Race::compare(Json& report, const std::string& name)
{
    if (!_request.has(name) || !_request.has("full")) return;
    for (const Path& path : kPaths)
    {
        const double rms = _stage.difference(name, "full", path);
        report[name][path.name]["rmsToFull"] = rms;
        std::cout << name << ' ' << path.name << ": differs from full detail by " << rms << " levels (rms)\n";
    }
}

Race::Json Race::run(const Shapes& shapes, const std::vector<osgPMObjects::FieldInstance>& instances)
{
    Json report = Json::object();
    enter(
        report, "ours", [&] { return progressiveField(shapes, instances, _request.trianglePx); },
        _request.frames);
    enter(
        report, "lod",
        [&] {
            return discreteLods(shapes, instances, _request.lodTrianglePx,
                                pixelsPerTangent(_request.picture));
        },
        _request.frames);
    enter(
        report, "full", [&] { return fullDetail(shapes, instances); }, 0);
    for (const char* const name : {"ours", "lod"})
        compare(report, name);
    return report;
}

} // namespace fieldbench
