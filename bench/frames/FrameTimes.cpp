// SPDX-License-Identifier: Apache-2.0
#include <iomanip>
#include <iostream>

#include "Look.h"
#include "Request.h"
#include "StaticMesh.h"
#include "Subjects.h"

namespace framebench
{

namespace
{

using measurement::percentile;

constexpr int kWarmUpFrames = 3; ///< these frames compile shaders and fill buffers

/// Draws one frame of a subject, and adds its cost if it `counts` (warm-up frames do not).
void drawOnce(Stage& stage, Subject& subject, const Eye& eye, DrawCount& drawn, bool counts)
{
    drawn.triangles = 0;
    const FrameCost cost = stage.draw(eye);
    if (!counts) return;
    subject.costs.add(cost);
    const auto groups =
        subject.roam ? subject.roam->statistics() : std::vector<osgTerrainROAM::ViewGroupStatistics>();
    subject.costs.triangles += groups.empty() ? static_cast<double>(drawn.triangles)
                                              : static_cast<double>(groups.front().trianglesDrawn);
}

Report rowOf(const Subject& subject, Look look)
{
    Report row;
    row["look"] = lookName(look);
    row["subject"] = subject.name;
    row["draws"] = subject.draws;
    subject.costs.appendTo(row);
    return row;
}

void printTimesRow(const Report& row)
{
    const auto number = [&](const char* key) { return row[key].get<double>(); };
    std::cout << std::left << std::setw(8) << row["look"].get<std::string>() << std::setw(36)
              << row["subject"].get<std::string>() << std::right << std::fixed << std::setprecision(0)
              << std::setw(10) << number("triangles") << " triangles" << std::setprecision(1) << std::setw(9)
              << number("wallMsP50") << " ms" << std::setw(9) << number("wallMsP99") << " ms p99"
              << std::setw(9) << number("cpuMsP50") << " ms cpu" << std::setprecision(2) << std::setw(8)
              << number("wallMsP50OverOurs") << " x" << std::endl;
}

void measureLook(const Request& request, Stage& stage, Look look, Report& report)
{
    const osg::ref_ptr<osg::StateSet> state = lookState(*request.material, look);
    std::vector<Subject> subjects = subjectsOf(request, look);
    DrawCount drawn;
    for (int frame = -kWarmUpFrames; frame < request.frames; ++frame)
        for (Subject& subject : subjects)
        {
            stage.show(subject.node, state);
            drawOnce(stage, subject, request.eye(frame), drawn, frame >= 0);
            // Counting starts after the first frame, in which osgTerrain builds its geometry.
            if (frame == -kWarmUpFrames) countDraws(*subject.node, drawn);
        }
    const double oursMs = percentile(subjects.front().costs.wallMs, 0.5);
    for (const Subject& subject : subjects)
    {
        Report row = rowOf(subject, look);
        row["wallMsP50OverOurs"] = row["wallMsP50"].get<double>() / oursMs;
        printTimesRow(row);
        report["rows"].push_back(std::move(row));
    }
}

} // namespace

foundation::Result<Report> measureFrames(const Request& request)
{
    auto stage = Stage::open(request.picture, request.tile->tile.frame().vertexStepM());
    if (!stage) return stage.error();
    Report report;
    report["renderer"] = (*stage)->rendererName();
    std::cout << (*stage)->rendererName() << '\n';
    for (const Look look : {Look::full, Look::relief})
        measureLook(request, **stage, look, report);
    return report;
}

} // namespace framebench
