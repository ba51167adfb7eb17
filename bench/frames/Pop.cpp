// SPDX-License-Identifier: Apache-2.0
#include <iomanip>
#include <iostream>
#include <map>

#include "PopRow.h"
#include "StaticMesh.h"

namespace framebench
{

namespace
{

constexpr Look kLooks[] = {Look::full, Look::relief};

using Edges = std::vector<std::vector<bool>>; ///< by frame and pixel

/// Returns, for each frame, the silhouettes of the full mesh in it and in the frame before, widened by a
/// pixel.
Edges edgesOf(const Request& request, Stage& stage, osg::Node* full)
{
    stage.show(full, lookState(*request.material, Look::distance), false);
    Edges edges;
    std::vector<bool> before;
    for (int frame = 0; frame < request.frames; ++frame)
    {
        std::vector<bool> now = silhouettes(*stage.picture(request.eye(frame)));
        edges.push_back(widened(now, before.empty() ? now : before, request.picture.widthPx));
        before = std::move(now);
    }
    return edges;
}

/// The changes of the full mesh's image from frame to frame, for comparison.
struct FullSteps
{
    void add(const Picture& picture)
    {
        if (!before.values.empty())
            for (const int v : difference(picture, before).values)
                levels.add(v);
        before = picture;
    }

    Picture before;
    LevelHistogram levels;
};

/// One way to antialias: samples of the renderer, or a larger picture that is filtered down.
struct Antialiasing
{
    std::string name;
    int samplesPerPx = 1; ///< along an axis
    osgOffscreen::OffscreenSettings picture;
};

/// Returns the settings of a way to antialias. `name`: none, msaa4, ssaa2 or ssaa4, which main.cpp checks.
Antialiasing antialiasingOf(const std::string& name, osgOffscreen::OffscreenSettings picture)
{
    const int perAxis = name == "ssaa4" ? 4 : name == "ssaa2" ? 2 : 1;
    picture.widthPx *= perAxis;
    picture.heightPx *= perAxis;
    picture.samples = name == "msaa4" ? 4 : 0;
    return {name, perAxis, picture};
}

std::vector<PopRow> rowsOf(const Request& request, const Antialiasing& way, Stage& stage)
{
    std::vector<PopRow> rows;
    for (const Look look : kLooks)
        for (const double tolerancePx : request.tolerancesPx)
            for (const Following following : {Following::switching, Following::morphing, Following::frozen})
                rows.emplace_back(request, stage,
                                  PopRow::Setting{look, tolerancePx, following, way.name, way.samplesPerPx});
    return rows;
}

void printPopRow(const Report& row)
{
    std::cout << std::left << std::setw(8) << row["look"].get<std::string>() << std::setw(7)
              << row["antialiasing"].get<std::string>() << std::setw(6) << row["tolerancePx"].get<double>()
              << std::setw(10) << row["mesh"].get<std::string>() << std::right << "p99.9:";
    for (const char* key : {"lodMinusFull", "delta", "deltaAtEdges", "deltaInside", "pop", "popInside"})
        if (row.contains(key))
            std::cout << "  " << key << std::setw(4) << row[key]["p999"].get<int>() << " (max" << std::setw(4)
                      << row[key]["max"].get<int>() << ')';
    std::cout << std::endl;
}

foundation::Outcome measure(const Request& request, const Antialiasing& way, Stage& stage, osg::Node* full,
                            const Edges& edges, Report& report)
{
    report["renderer"] = stage.rendererName();
    std::map<Look, osg::ref_ptr<osg::StateSet>> states;
    for (const Look look : kLooks)
        states[look] = lookState(*request.material, look);
    std::vector<PopRow> rows = rowsOf(request, way, stage);
    std::map<Look, FullSteps> steps;
    for (int frame = 0; frame < request.frames; ++frame)
        for (const Look look : kLooks)
        {
            stage.show(full, states[look]);
            const Picture whole = boxFiltered(*stage.picture(request.eye(frame)), way.samplesPerPx);
            steps[look].add(whole);
            for (PopRow& row : rows)
            {
                if (row.look() != look) continue;
                if (const auto done = row.frame(frame, whole, edges[static_cast<std::size_t>(frame)]); !done)
                    return done.error();
            }
        }
    for (const PopRow& row : rows)
    {
        report["rows"].push_back(row.json());
        report["rows"].back()["fullStepP999"] = steps[row.look()].levels.percentile(0.999);
        printPopRow(report["rows"].back());
    }
    return foundation::success();
}

} // namespace

foundation::Result<Report> measurePop(const Request& request)
{
    const osg::ref_ptr<osg::Node> full = fullGrid(request.tile->tile, kFullGridPatchCells);
    // No stage is closed before the end. Otherwise OSG would give its context number to the next stage, and
    // nodes that both draw would expect their buffers in the new context.
    std::vector<std::unique_ptr<Stage>> stages;
    const auto open = [&](const osgOffscreen::OffscreenSettings& picture) -> foundation::Outcome
    {
        auto stage = Stage::open(picture, request.tile->tile.frame().vertexStepM());
        if (!stage) return stage.error();
        stages.push_back(std::move(*stage));
        return foundation::success();
    };
    if (const auto opened = open(request.picture); !opened) return opened.error();
    const Edges edges = edgesOf(request, *stages.front(), full);
    Report report;
    for (const std::string& name : request.antialiasing)
    {
        const Antialiasing way = antialiasingOf(name, request.picture);
        if (const auto opened = open(way.picture); !opened) return opened.error();
        if (const auto done = measure(request, way, *stages.back(), full, edges, report); !done)
            return done.error();
    }
    return report;
}

} // namespace framebench
