// SPDX-License-Identifier: Apache-2.0
#include "Race.h"

#include <cmath>
#include <iostream>

#include <glm/gtc/matrix_transform.hpp>
#include <malloc.h>

#include <viewlod/ViewState.h>

#include "Times.h"

namespace fieldbench
{

namespace
{

const std::string kFull = "full";

/// Returns the memory in use by the whole process, the software renderer included.
double megabytesInUse()
{
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd) / 1e6;
}

/// Returns the pixels per unit of tangent at the centre of the picture.
double pixelsPerTangent(const osgOffscreen::OffscreenSettings& picture)
{
    const double aspect = static_cast<double>(picture.widthPx) / picture.heightPx;
    return viewlod::ViewState::fromMatrices(glm::dmat4(1.0),
                                            glm::perspective(glm::radians(kHighDeg), aspect, 0.5, 2e4),
                                            picture.widthPx, picture.heightPx)
        .pixelsPerTangent;
}

} // namespace

Race::Json Race::flown(const std::string& name, const Make& make, int frames)
{
    const double before = megabytesInUse();
    const auto began = Clock::now();
    const osg::ref_ptr<osg::Node> objects = make();
    // This counts the scene graph only: the renderer has not drawn it yet.
    Json row = {{"buildS", 1e-3 * milliseconds(began)}, {"graphMegabytes", megabytesInUse() - before}};
    for (const Path& path : kPaths)
    {
        row[path.name] = _stage.fly(name, *objects, path, frames);
        if (name != kFull && _request.has(kFull))
            row[path.name]["rmsToFull"] = _stage.difference(name, kFull, path);
    }
    if (const auto* const ours = dynamic_cast<osgPMObjects::ProgressiveField*>(objects.get()))
        for (const auto& statistics : ours->statistics())
            row["last"] = {{"visible", statistics.visible},
                           {"cullMs", statistics.cullMs},
                           {"cullNsPerVisible", 1e6 * statistics.cullMs / std::max(1u, statistics.visible)},
                           {"triangles", statistics.triangles},
                           {"drawCalls", statistics.drawCalls}};
    _stage.clear();
    std::cout << name << ": " << row.dump() << std::endl;
    return row;
}

Race::Json Race::flownAt(const std::string& name, const std::vector<double>& trianglesPx,
                         const std::function<osg::ref_ptr<osg::Node>(double)>& make)
{
    Json rows = Json::array();
    for (const double px : trianglesPx)
    {
        Json row = {{"trianglePx", px}};
        row.update(flown(
            name + "-" + std::to_string(std::lround(px)), [&] { return make(px); }, _request.frames));
        rows.push_back(row);
    }
    return rows;
}

Race::Json Race::run(const Shapes& shapes, const std::vector<osgPMObjects::FieldInstance>& instances)
{
    Json report = Json::object();
    if (_request.has(kFull)) // first: the others are compared with it
        report[kFull] = flown(
            kFull, [&] { return fullDetail(shapes, instances); }, 0);
    if (_request.has("ours"))
        report["ours"] = flownAt("ours", _request.trianglesPx,
                                 [&](double px) { return progressiveField(shapes, instances, px); });
    const double perTangent = pixelsPerTangent(_request.picture);
    if (_request.has("lod"))
        report["lod"] = flownAt("lod", _request.lodTrianglesPx,
                                [&](double px) { return discreteLods(shapes, instances, px, perTangent); });
    return report;
}

} // namespace fieldbench
