// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <iostream>
#include <numbers>
#include <thread>

#include <sys/resource.h>

#include <osgMultiTriangulation/core/follow/DrawnSurfaceCheck.h>
#include <osgMultiTriangulation/core/follow/SampledSurface.h>
#include <osgMultiTriangulation/core/follow/SurfaceFollower.h>

#include "terraintool/mt/MtRequest.h"

namespace terraintool
{

namespace
{

using namespace osgMultiTriangulation::core;
using Clock = std::chrono::steady_clock;

double processorOfThreadUs()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// How often this thread has given up the processor to wait for something, and how often it lost it to
/// others.
struct Switches
{
    long waits = 0, losses = 0;
};

Switches switchesOfThread()
{
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return {usage.ru_nvcsw, usage.ru_nivcsw};
}

/// Heights of the ground under a flight.
class GroundBelow
{
public:
    explicit GroundBelow(SampledSurface sampled) : _ground(std::move(sampled)) {}

    double at(double x, double y) const
    {
        const auto place = [](double along, double spacing, int count)
        { return static_cast<std::size_t>(std::clamp(std::lround(along / spacing), 0L, count - 1L)); };
        return _ground.heights[place(y, _ground.spacingY, _ground.rows) * _ground.columns +
                               place(x, _ground.spacingX, _ground.columns)];
    }

    double width() const { return (_ground.columns - 1) * _ground.spacingX; }
    double depth() const { return (_ground.rows - 1) * _ground.spacingY; }

private:
    SampledSurface _ground;
};

/// Straight on; in the third quarter with turns to both sides; then an about-face.
class FlightPath
{
public:
    explicit FlightPath(const GroundBelow& ground)
        : _ground(ground), _x(0.15 * ground.width()), _y(0.2 * ground.depth()), _heading(std::atan2(0.5, 0.7))
    {
    }

    /// Flies on. `share`: of the whole flight.
    glm::dvec3 step(double share, double wayM, double aboveM)
    {
        const double turn =
            share > 0.5 && share < 0.75 ? std::sin((share - 0.5) * 16.0 * std::numbers::pi) : 0.0;
        if (share >= 0.75 && !_isBack)
        {
            _heading += std::numbers::pi;
            _isBack = true;
        }
        _heading += turn * wayM / 400.0;
        if (_x < 0.0 || _x > _ground.width() || _y < 0.0 || _y > _ground.depth())
            _heading = std::atan2(0.5 * _ground.depth() - _y, 0.5 * _ground.width() - _x);
        _x += wayM * std::cos(_heading);
        _y += wayM * std::sin(_heading);
        return {_x, _y, _ground.at(_x, _y) + aboveM};
    }

private:
    const GroundBelow& _ground;
    double _x, _y, _heading;
    bool _isBack = false;
};

double percentile(std::vector<double> values, double share)
{
    if (values.empty()) return 0.0;
    std::ranges::sort(values);
    return values[std::min(values.size() - 1,
                           static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

/// What a flight came to, frame by frame.
struct FlownFrames
{
    std::vector<double> stallsUs, processorUs, errorsPx;
    std::vector<double> keptUs; ///< the stalls of frames that did not lose the processor to others
    std::size_t blocked = 0;    ///< frames that gave up the processor to wait
    std::size_t mostTriangles = 0, mostBytes = 0, checked = 0;
    std::optional<std::string> fault;
};

FlownFrames flyAlong(SurfaceFollower& follower, const GroundBelow& ground, const MtFlyRequest& request)
{
    const double pixels = request.widthPx / (2.0 * std::tan(std::numbers::pi / 6.0)); // 60 degrees across
    const std::vector<OutlineSide> outline = outlineOf(latticeMeshOf(*follower.coarsest(), follower.frame()));
    const std::size_t view = follower.addView();
    FlightPath path(ground);
    FlownFrames flown;
    const int frames = static_cast<int>(request.seconds * 60.0);
    auto next = Clock::now();
    std::uint64_t lastChecked = 0;
    std::shared_ptr<const DrawnSurface> surface;
    for (int frame = 0; frame < frames; ++frame)
    {
        const glm::dvec3 eye = path.step(double(frame) / frames, request.speedMps / 60.0, request.aboveM);
        const FollowTarget target{eye, request.tolerancePx / pixels, 1.0};
        if (frame == 0) surface = follower.settle(view, target);
        const Switches switches = switchesOfThread();
        const double processor = processorOfThreadUs();
        const auto before = Clock::now();
        if (auto newest = follower.follow(view, target)) surface = std::move(newest);
        flown.stallsUs.push_back(std::chrono::duration<double, std::micro>(Clock::now() - before).count());
        flown.processorUs.push_back(processorOfThreadUs() - processor);
        const Switches after = switchesOfThread();
        flown.blocked += after.waits != switches.waits;
        if (after.losses == switches.losses) flown.keptUs.push_back(flown.stallsUs.back());
        flown.mostTriangles = std::max(flown.mostTriangles, surface->triangles.size());
        flown.mostBytes = std::max(flown.mostBytes, follower.figures().memoryBytes);
        if (frame % 6 == 0)
            flown.errorsPx.push_back(pixels * seenErrorPerDistance(*surface, follower.frame(), eye, 1.0));
        if (frame % 30 == 0 && surface->serial != lastChecked && !flown.fault)
        {
            flown.fault = checkDrawn(*surface, follower.frame(), outline);
            lastChecked = surface->serial;
            ++flown.checked;
        }
        next += std::chrono::microseconds(16667);
        std::this_thread::sleep_until(next);
    }
    return flown;
}

} // namespace

foundation::Result<terminal::Report> flyMt(const MtFlyRequest& request)
{
    auto file = MtFile::open(request.file);
    if (!file) return file.error();
    auto sampled = sampleSurface(*file, 257);
    if (!sampled) return sampled.error();
    const GroundBelow ground(std::move(*sampled));
    ZoneSettings zone;
    zone.memoryBytes = static_cast<std::size_t>(1e6 * request.memoryMb);
    if (request.megabytesPerS > 0.0) zone.mostBytesPerS = 1e6 * request.megabytesPerS;
    auto follower = SurfaceFollower::open(std::move(*file), zone, 1.0 / 1024.0);
    if (!follower) return follower.error();
    const FlownFrames flown = flyAlong(**follower, ground, request);
    const FollowFigures figures = (*follower)->figures();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    terminal::Report report;
    report.sound = !flown.fault;
    auto& row = report.json["flights"].emplace_back();
    row["file"] = request.file.string();
    row["frames"] = flown.stallsUs.size();
    row["stallUs"] = {{"median", percentile(flown.stallsUs, 0.5)},
                      {"p99", percentile(flown.stallsUs, 0.99)},
                      {"p999", percentile(flown.stallsUs, 0.999)},
                      {"most", percentile(flown.stallsUs, 1.0)}};
    row["keptUs"] = {{"frames", flown.keptUs.size()},
                     {"p999", percentile(flown.keptUs, 0.999)},
                     {"most", percentile(flown.keptUs, 1.0)}};
    row["processorUs"] = {{"median", percentile(flown.processorUs, 0.5)},
                          {"p999", percentile(flown.processorUs, 0.999)},
                          {"most", percentile(flown.processorUs, 1.0)}};
    row["blockedFrames"] = flown.blocked;
    row["errorPx"] = {{"median", percentile(flown.errorsPx, 0.5)},
                      {"p99", percentile(flown.errorsPx, 0.99)},
                      {"most", percentile(flown.errorsPx, 1.0)}};
    row["checkedSurfaces"] = flown.checked;
    row["fault"] = flown.fault ? nlohmann::ordered_json(*flown.fault) : nlohmann::ordered_json();
    row["surfaces"] = figures.surfaces;
    row["mostTriangles"] = flown.mostTriangles;
    row["reads"] = figures.reads;
    row["readMB"] = static_cast<double>(figures.readBytes) / 1e6;
    row["treesMB"] = static_cast<double>(flown.mostBytes) / 1e6;
    row["limitMB"] = request.memoryMb;
    row["peakMB"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
    row["damagedTrees"] = figures.faults;
    std::cout << request.file.string() << ": " << row["frames"] << " frames, " << flown.checked
              << " surfaces checked, " << (flown.fault ? *flown.fault : "no hole") << "\n  a frame waits "
              << row["stallUs"]["p99"] << " us at 99 %, " << row["stallUs"]["p999"] << " at 99.9 %, "
              << flown.blocked << " frames were blocked, " << flown.stallsUs.size() - flown.keptUs.size()
              << " lost their processor; error " << row["errorPx"]["median"] << " px, "
              << row["errorPx"]["p99"] << " at 99 %\n  trees " << row["treesMB"] << " of " << request.memoryMb
              << " MB, the process " << row["peakMB"] << " MB, " << figures.reads << " reads\n";
    return report;
}

} // namespace terraintool
