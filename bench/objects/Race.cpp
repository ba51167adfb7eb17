// SPDX-License-Identifier: Apache-2.0
#include "Race.h"

#include <algorithm>
#include <chrono>

#include "Finish.h"
#include "VertexLights.h"
#include "measurement/Percentile.h"

namespace objectbench
{

namespace
{

/// Frames that are drawn before measuring. After a jump to a distant level its faces have the order of the
/// finest level; the arranged order follows within these frames.
constexpr int kSettling = 24;

} // namespace

Race::Race(osgOffscreen::OffscreenViewer& viewer, const Request& request)
    : _viewer(viewer), _count(viewer.camera(), PipelineCount::kVertexShaderInvocations), _request(request)
{
    viewer.camera().setFinalDrawCallback(new Finish);
}

Race::Json Race::run(const std::vector<Contestant>& contestants, const std::vector<std::uint32_t>& levels,
                     std::uint32_t mostSteps, int lights, const osg::BoundingSphere& ball)
{
    look(ball);
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->setStateSet(vertexLights(lights, ball));
    _viewer.viewer().setSceneData(scene);
    Json rows = Json::array();
    for (const std::uint32_t steps : levels)
    {
        std::vector<std::vector<double>> times(contestants.size());
        std::vector<std::uint64_t> invocations(contestants.size());
        std::vector<osg::ref_ptr<osg::Node>> nodes;
        for (const Contestant& contestant : contestants)
            nodes.push_back(contestant.nodeAt(steps));
        for (int repeat = -kSettling; repeat < _request.repeats; ++repeat)
            for (std::size_t i = 0; i < contestants.size(); ++i)
            {
                const auto moved = static_cast<std::uint32_t>(0.01 * _request.movingPercent * mostSteps);
                if (moved > 0) // to and fro
                    nodes[i] =
                        contestants[i].nodeAt(std::min(mostSteps, steps + (repeat % 2 == 0 ? 0 : moved)));
                scene->removeChildren(0, scene->getNumChildren());
                scene->addChild(nodes[i]);
                _count.setCounting(repeat == -1);
                const double ms = frameMs();
                if (repeat == -1)
                    invocations[i] = _count.counted();
                else if (repeat >= 0)
                    times[i].push_back(ms);
            }
        Json row = {{"steps", steps}};
        for (std::size_t i = 0; i < contestants.size(); ++i)
            row[contestants[i].name] = {{"ms", shownMs(times[i])},
                                        {"medianMs", measurement::percentile(times[i], 0.5)},
                                        {"p99Ms", measurement::percentile(times[i], 0.99)},
                                        {"invocations", invocations[i]}};
        rows.push_back(std::move(row));
    }
    return rows;
}

/// The least time of frames at rest, since other programs only add to it; the median of moving ones, half of
/// which go each way.
double Race::shownMs(std::vector<double> times) const
{
    std::sort(times.begin(), times.end());
    return times[_request.movingPercent > 0.0 ? times.size() / 2 : 0];
}

double Race::frameMs()
{
    const auto start = std::chrono::steady_clock::now();
    _viewer.frame(0.0);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void Race::look(const osg::BoundingSphere& ball)
{
    const double away = ball.radius() / std::sin(osg::DegreesToRadians(15.0));
    const osg::Vec3d from = osg::Vec3d(ball.center()) + osg::Vec3d(0.66, -0.66, 0.36) * away;
    _viewer.camera().setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    _viewer.camera().setProjectionMatrixAsPerspective(
        30.0, static_cast<double>(_request.picture.widthPx) / _request.picture.heightPx,
        away - 1.1 * ball.radius(), away + 1.1 * ball.radius());
    _viewer.camera().setViewMatrixAsLookAt(from, ball.center(), {0.0, 0.0, 1.0});
}

} // namespace objectbench
