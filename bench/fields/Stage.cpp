// SPDX-License-Identifier: Apache-2.0
#include "Stage.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include <osgOffscreen/PngFile>

#include "Times.h"
#include "measurement/Percentile.h"
#include "models/Plain.h"
#include "objects/Finish.h"

namespace fieldbench
{

namespace
{

constexpr double kFrameS = 0.04;
constexpr double kSettledS = 2.0; ///< every switch has ended after this time
constexpr int kRounds = 5;        ///< flights along a path; the fastest time of each frame counts

} // namespace

Stage::Stage(osgOffscreen::OffscreenViewer& viewer, const Request& request)
    : _viewer(viewer),
      _count(viewer.camera(), objectbench::PipelineCount::kVertexShaderInvocations),
      _request(request),
      _air(new osgSky::Atmosphere)
{
    viewer.camera().setProjectionMatrixAsPerspective(
        kHighDeg, static_cast<double>(request.picture.widthPx) / request.picture.heightPx, 0.5, 2e4);
    viewer.camera().setFinalDrawCallback(new objectbench::Finish);
}

Stage::Json Stage::fly(const std::string& name, osg::Node& objects, const Path& path, int frames)
{
    _viewer.viewer().setSceneData(onPlain(objects, *_air));
    std::vector<double> times(frames, std::numeric_limits<double>::infinity()), invocations;
    for (int round = 0; round <= kRounds; ++round)
        for (int i = 0; i < frames; ++i)
        {
            const double ms = frameMs(path, i);
            if (round > 0) times[i] = std::min(times[i], ms); // in the first round shaders compile
        }
    auto& pictures = _pictures[name + path.name];
    pictures.clear();
    for (int i = 0; i < _request.compared; ++i)
    {
        const int at = i * (_request.frames - 1) / std::max(1, _request.compared - 1);
        look(path, at);
        _count.setCounting(false);
        const auto begin = Clock::now();
        const auto picture = _viewer.picture(_timeS += kSettledS);
        if (frames == 0) times.push_back(milliseconds(begin));
        _count.setCounting(true);
        _viewer.frame(_timeS += kSettledS);
        _count.setCounting(false);
        invocations.push_back(static_cast<double>(_count.counted()));
        keep(*picture, name + "-" + path.name + "-" + std::to_string(i));
        pictures.push_back(picture);
    }
    double sum = 0.0;
    for (const double i : invocations)
        sum += i;
    return {{"medianMs", measurement::percentile(times, 0.5)},
            {"p99Ms", measurement::percentile(times, 0.99)},
            {"invocations", sum / static_cast<double>(invocations.size())}};
}

double Stage::difference(const std::string& name, const std::string& other, const Path& path) const
{
    double sum = 0.0, values = 0.0;
    for (int i = 0; i < _request.compared; ++i)
    {
        const osg::Image& a = *_pictures.at(name + path.name)[i];
        const osg::Image& b = *_pictures.at(other + path.name)[i];
        for (unsigned at = 0; at < a.getTotalSizeInBytes(); ++at, ++values)
            sum += std::pow(static_cast<double>(a.data()[at]) - b.data()[at], 2.0);
    }
    return std::sqrt(sum / values);
}

void Stage::clear()
{
    _viewer.viewer().setSceneData(new osg::Group);
}

double Stage::frameMs(const Path& path, int frame)
{
    look(path, frame);
    const auto begin = Clock::now();
    _viewer.frame(_timeS += kFrameS);
    return milliseconds(begin);
}

void Stage::look(const Path& path, int frame)
{
    const osg::Vec3d eye(-72.0, -300.0 + path.stepM * frame, path.heightM); // between the objects
    const osg::Vec3d along(0.1, 1.0, path.pitch);
    _viewer.camera().setViewMatrixAsLookAt(eye, eye + along, {0.0, 0.0, 1.0});
}

void Stage::keep(const osg::Image& picture, const std::string& name) const
{
    if (_request.pictures.empty()) return;
    const auto written = osgOffscreen::writePng(picture, _request.pictures / (name + ".png"));
    if (!written) std::cerr << written.error().message() << '\n';
}

} // namespace fieldbench
