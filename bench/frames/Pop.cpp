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
constexpr int kPatchCells = 64;

using Edges = std::vector<std::vector<bool>>; ///< of every frame

/// The silhouettes of the full mesh in each frame, widened by a pixel, with those of the frame before.
viewlod::Result<Edges> edgesOf(const Request& request, osg::Node* full)
{
    auto stage = Stage::open(request.picture, request.tile->tile.vertexStepM());
    if (!stage) return stage.error();
    (*stage)->show(full, lookState(*request.material, Look::distance), false);
    Edges edges;
    std::vector<bool> before;
    for (int frame = 0; frame < request.frames; ++frame)
    {
        std::vector<bool> now = silhouettes(*(*stage)->picture(request.eye(frame)));
        edges.push_back(widened(now, before.empty() ? now : before, request.picture.widthPx));
        before = std::move(now);
    }
    return edges;
}

/// One way to antialias: samples of the renderer, or a larger picture that is filtered down.
struct Antialiasing
{
    std::string name;
    int samplesPerPx = 1; ///< along an axis
    osgOffscreen::OffscreenSettings picture;
};

viewlod::Result<Antialiasing> antialiasingOf(const std::string& name, osgOffscreen::OffscreenSettings picture)
{
    static const std::map<std::string, std::pair<int, int>> kKnown{
        {"none", {1, 0}}, {"msaa4", {1, 4}}, {"ssaa2", {2, 0}}, {"ssaa4", {4, 0}}};
    const auto known = kKnown.find(name);
    if (known == kKnown.end())
        return viewlod::Error{"--antialiasing", "'" + name + "' is not known",
                              "choose none, msaa4, ssaa2 or ssaa4"};
    const auto [perAxis, samples] = known->second;
    picture.widthPx *= perAxis;
    picture.heightPx *= perAxis;
    picture.samples = samples;
    return Antialiasing{name, perAxis, picture};
}

std::vector<PopRow> rowsOf(const Request& request, int samplesPerPx)
{
    std::vector<PopRow> rows;
    for (const Look look : kLooks)
        for (const double tolerancePx : request.tolerancesPx)
            for (const bool morphing : {false, true})
                rows.emplace_back(request, look, tolerancePx, morphing, samplesPerPx);
    return rows;
}

void print(const Report& row)
{
    const auto p999 = [&](const char* key) { return row[key]["p999"].get<int>(); };
    std::cout << std::left << std::setw(8) << row["look"].get<std::string>() << std::setw(7)
              << row["antialiasing"].get<std::string>() << std::setw(5) << row["tolerancePx"].get<double>()
              << (row["morphing"].get<bool>() ? "morphing " : "         ") << std::right << "p99.9: apart"
              << std::setw(4) << p999("lodMinusFull") << "  delta" << std::setw(4) << p999("delta")
              << "  at edges" << std::setw(4) << p999("deltaAtEdges") << "  inside" << std::setw(4)
              << p999("deltaInside") << "  pop" << std::setw(4) << p999("pop") << "  inside" << std::setw(4)
              << p999("popInside") << "  max pop" << std::setw(4) << row["pop"]["max"].get<int>()
              << std::endl;
}

viewlod::Outcome measure(const Request& request, const Antialiasing& way, osg::Node* full, const Edges& edges,
                         Report& report)
{
    auto opened = Stage::open(way.picture, request.tile->tile.vertexStepM());
    if (!opened) return opened.error();
    Stage& stage = **opened;
    report["renderer"] = stage.rendererName();
    std::vector<PopRow> rows = rowsOf(request, way.samplesPerPx);
    for (int frame = 0; frame < request.frames; ++frame)
        for (const Look look : kLooks)
        {
            stage.show(full, lookState(*request.material, look));
            const Picture whole = boxFiltered(*stage.picture(request.eye(frame)), way.samplesPerPx);
            for (PopRow& row : rows)
            {
                if (row.look() != look) continue;
                const auto& at = edges[static_cast<std::size_t>(frame)];
                if (const auto done = row.frame(request, stage, frame, whole, at, way.name); !done)
                    return done.error();
            }
        }
    for (const PopRow& row : rows)
    {
        report["rows"].push_back(row.json(way.name));
        print(report["rows"].back());
    }
    return viewlod::success();
}

} // namespace

viewlod::Result<Report> measurePop(const Request& request)
{
    const osg::ref_ptr<osg::Node> full = fullGrid(request.tile->tile, kPatchCells);
    const auto edges = edgesOf(request, full);
    if (!edges) return edges.error();
    Report report;
    for (const std::string& name : request.antialiasing)
    {
        const auto way = antialiasingOf(name, request.picture);
        if (!way) return way.error();
        if (const auto done = measure(request, *way, full, *edges, report); !done) return done.error();
    }
    return report;
}

} // namespace framebench
