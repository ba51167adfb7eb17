// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cstdio>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>

#include <osgTerrain/GeometryTechnique>
#include <osgTerrain/TerrainTile>

#include <osgTerrainROAM/RoamTechnique>

#include "FrameCosts.h"
#include "Request.h"
#include "StaticMesh.h"
#include "TiledDatabase.h"

namespace framebench
{

namespace
{

using measurement::percentile;
using osgTerrainROAM::RoamTechnique;

constexpr int kDatabaseWarmUpFrames = 3; ///< these frames upload textures and buffers

/// A database under one technique, and its measurements.
struct Candidate
{
    std::string name;
    osg::ref_ptr<osgTerrain::Terrain> terrain;
    double buildMs = 0.0; ///< of all tiles, in one thread
    FrameCosts costs;
    DrawCount drawn; ///< triangles of osg::Geometry, which only GeometryTechnique draws
};

osg::ref_ptr<RoamTechnique> ours(double tolerancePx, bool morphing)
{
    osg::ref_ptr<RoamTechnique> technique = new RoamTechnique;
    const auto set = technique->setSettings({.errorTolerancePx = tolerancePx, .morphing = morphing});
    if (!set) std::fprintf(stderr, "%s\n", set.error().message().c_str()); // measures with the default
    return technique;
}

void build(Candidate& candidate)
{
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    for (unsigned int i = 0; i < candidate.terrain->getNumChildren(); ++i)
    {
        auto& tile = static_cast<osgTerrain::TerrainTile&>(*candidate.terrain->getChild(i));
        tile.setTerrain(candidate.terrain);
        tile.init(osgTerrain::TerrainTile::ALL_DIRTY, false);
    }
    candidate.buildMs = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Returns the triangles of the last frame. Tiles out of sight keep the numbers of an earlier frame, which do
/// not count.
std::uint64_t trianglesOf(const Candidate& candidate)
{
    std::map<unsigned int, std::uint64_t> byFrame{{0, candidate.drawn.triangles}};
    for (unsigned int i = 0; i < candidate.terrain->getNumChildren(); ++i)
    {
        auto& tile = static_cast<osgTerrain::TerrainTile&>(*candidate.terrain->getChild(i));
        const auto* technique = dynamic_cast<const RoamTechnique*>(tile.getTerrainTechnique());
        if (!technique) continue;
        for (const auto& group : technique->drawable()->statistics())
            byFrame[group.frame] += group.trianglesDrawn;
    }
    return byFrame.rbegin()->second;
}

void drawOnce(Stage& stage, Candidate& candidate, const Eye& eye, bool counts)
{
    stage.show(candidate.terrain, nullptr);
    candidate.drawn.triangles = 0;
    const FrameCost cost = stage.draw(eye);
    if (!counts) return;
    candidate.costs.add(cost);
    candidate.costs.triangles += static_cast<double>(trianglesOf(candidate));
}

Report rowOf(const Candidate& candidate, double stockMs)
{
    Report row;
    row["technique"] = candidate.name;
    row["tiles"] = candidate.terrain->getNumChildren();
    row["buildMs"] = candidate.buildMs;
    candidate.costs.appendTo(row);
    row["stockWallMsP50OverThis"] = stockMs / row["wallMsP50"].get<double>();
    return row;
}

void printDatabaseRow(const Report& row)
{
    const auto number = [&](const char* key) { return row[key].get<double>(); };
    std::cout << std::left << std::setw(32) << row["technique"].get<std::string>() << std::right << std::fixed
              << std::setprecision(0) << std::setw(9) << number("triangles") << " triangles" << std::setw(7)
              << number("buildMs") << " ms to build" << std::setprecision(1) << std::setw(8)
              << number("wallMsP50") << " ms" << std::setw(8) << number("wallMsP99") << " ms p99"
              << std::setw(8) << number("cpuMsP50") << " ms cpu" << std::setw(8) << number("cpuMsP99")
              << " p99" << std::setprecision(2) << std::setw(7) << number("stockWallMsP50OverThis") << " x"
              << std::endl;
}

std::vector<Candidate> candidatesOf(const Request& request)
{
    const auto& tile = request.tile->tile;
    std::vector<Candidate> candidates;
    const auto add = [&](const std::string& name, osgTerrain::TerrainTechnique* technique) {
        candidates.push_back({name, tiledDatabase(tile, request.tileCells, technique), 0.0, {}, {}});
    };
    add("GeometryTechnique", new osgTerrain::GeometryTechnique);
    for (const double tolerancePx : request.tolerancesPx)
        for (const bool morphing : {false, true})
        {
            std::ostringstream name;
            name << "RoamTechnique " << tolerancePx << " px" << (morphing ? ", morphing" : "");
            add(name.str(), ours(tolerancePx, morphing));
        }
    for (Candidate& candidate : candidates)
        build(candidate);
    countDraws(*candidates.front().terrain, candidates.front().drawn);
    return candidates;
}

} // namespace

foundation::Result<Report> measureDatabase(const Request& request)
{
    if ((request.tile->tile.grid().side() - 1) % request.tileCells != 0)
        return foundation::Error{"--tile-cells", "the square does not divide into such tiles",
                                 "choose a power of two"};
    auto stage = Stage::open(request.picture, request.tile->tile.frame().vertexStepM());
    if (!stage) return stage.error();
    Report report;
    report["renderer"] = (*stage)->rendererName();
    report["tileCells"] = request.tileCells;
    std::vector<Candidate> candidates = candidatesOf(request);
    for (int frame = -kDatabaseWarmUpFrames; frame < request.frames; ++frame)
        for (Candidate& candidate : candidates)
            drawOnce(**stage, candidate, request.eye(frame), frame >= 0);
    const double stockMs = percentile(candidates.front().costs.wallMs, 0.5);
    for (const Candidate& candidate : candidates)
    {
        report["rows"].push_back(rowOf(candidate, stockMs));
        printDatabaseRow(report["rows"].back());
    }
    return report;
}

} // namespace framebench
