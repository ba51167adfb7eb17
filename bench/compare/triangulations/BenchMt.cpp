// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>

#include <osgMultiTriangulation/core/extract/Extraction.h>
#include <osgMultiTriangulation/core/file/BuildMtFile.h>
#include <osgMultiTriangulation/core/file/MtFile.h>
#include <osgMultiTriangulation/core/input/Delaunay.h>
#include <osgMultiTriangulation/core/input/PointDistribution.h>

#include "compare/triangulations/BenchMtWithin.h"
#include "compare/triangulations/MtBenchRequest.h"
#include "compare/triangulations/SweepsMt.h"
#include "measurement/ProcessorTime.h"
#include "terraintool/mt/ForestFigures.h"
#include "terraintool/mt/MtRequest.h"

namespace terraintool
{

namespace
{

using namespace osgMultiTriangulation::core;
using measurement::processorMs;

const std::map<std::string, PointDistribution> kDistributions{{"uniform", PointDistribution::uniform},
                                                              {"normal", PointDistribution::normal},
                                                              {"laplace", PointDistribution::laplace},
                                                              {"clustered", PointDistribution::clustered}};

double wallMs()
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Reads all trees of a file and takes the drain. Returns the time.
foundation::Result<double> extractAll(const std::filesystem::path& path, std::size_t triangles)
{
    const auto file = MtFile::open(path);
    if (!file) return file.error();
    std::vector<ReadTree> trees;
    for (std::uint32_t t = 0; t < file->info().trees.size(); ++t)
    {
        const std::uint32_t parent = file->info().trees[t].parent;
        auto tree = file->read(t, parent == kNone ? nullptr : &trees[parent]);
        if (!tree) return tree.error();
        trees.push_back(std::move(*tree));
    }
    const double before = processorMs();
    Extraction extraction(trees[0].tree);
    for (std::uint32_t t = 1; t < trees.size(); ++t)
        extraction.attach(t, trees[t].tree);
    extraction.refine([](const MultiTriangulation&, std::uint32_t) { return true; });
    const double spent = processorMs() - before;
    if (extraction.active().size() != triangles)
        return foundation::Error{path.string(), "its drain is not the input", "report this"};
    return spent;
}

foundation::Result<nlohmann::ordered_json> benchCase(const std::string& name, std::size_t count,
                                                     const MtBenchRequest& request)
{
    std::vector<SurfacePoint> points = madeUpPoints(kDistributions.at(name), count);
    const std::filesystem::path file = request.folder / (name + std::to_string(count) + ".mt");
    const double wall = wallMs(), processor = processorMs();
    const SurfaceMesh mesh = delaunay(std::move(points));
    const double triangulated = processorMs();
    const auto built = buildMtFile(mesh, {}, request.options, file);
    if (!built) return built.error();
    nlohmann::ordered_json row;
    row["distribution"] = name;
    row["points"] = count;
    row["buildMs"] = wallMs() - wall;
    row["processorMs"] = processorMs() - processor;
    row["delaunayMs"] = triangulated - processor;
    addForestFigures(row, *built);
    row["peakMB"] = peakMb();
    row["limitMB"] = nullptr;
    row["fileBytes"] = std::filesystem::file_size(file);
    const auto extractMs = extractAll(file, mesh.triangles.size());
    if (!extractMs) return extractMs.error();
    row["extractMs"] = *extractMs;
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    return row;
}

/// Fits a power law y = factor · x^exponent by least squares of logarithms.
nlohmann::ordered_json fitted(const std::vector<std::pair<double, double>>& pairs)
{
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const auto& [a, b] : pairs)
    {
        x += std::log(a);
        y += std::log(b);
        xx += std::log(a) * std::log(a);
        xy += std::log(a) * std::log(b);
    }
    const auto n = static_cast<double>(pairs.size());
    const double exponent = (n * xy - x * y) / (n * xx - x * x);
    return {{"exponent", exponent}, {"factor", std::exp((y - exponent * x) / n)}};
}

} // namespace

foundation::Result<terminal::Report> benchMt(const MtBenchRequest& request)
{
    terminal::Report report;
    if (request.hasSweeps)
    {
        const std::string name = request.distribution.empty() ? "uniform" : request.distribution;
        const auto sweeps =
            sweepsOver(delaunay(madeUpPoints(kDistributions.at(name), request.points[0])), request);
        if (!sweeps) return sweeps.error();
        report.json["sweeps"] = *sweeps;
        return report;
    }
    for (const auto& [name, distribution] : kDistributions)
    {
        if (!request.distribution.empty() && request.distribution != name) continue;
        std::vector<std::pair<double, double>> times, borders;
        for (const std::size_t count : request.points)
        {
            auto row = request.memoryMb > 0.0 ? benchCaseWithin(name, distribution, count, request)
                                              : benchCase(name, count, request);
            if (!row) return row.error();
            std::cout << name << ' ' << count << ": " << (*row)["processorMs"].get<double>()
                      << " ms of the processor\n"
                      << std::flush;
            times.emplace_back(static_cast<double>(count), (*row)["processorMs"].get<double>());
            if ((*row)["rectangles"] > 1)
                borders.emplace_back(static_cast<double>(count) / (*row)["rectangles"].get<double>(),
                                     (*row)["borderPoints"].get<double>());
            report.json["cases"].push_back(std::move(*row));
        }
        if (times.size() > 1) report.json["growth"][name] = fitted(times);
        if (borders.size() > 1) report.json["borders"][name] = fitted(borders);
    }
    return report;
}

} // namespace terraintool
