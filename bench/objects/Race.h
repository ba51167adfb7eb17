// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "Contestants.h"
#include "PipelineCount.h"
#include "Request.h"

namespace objectbench
{

/// Draws contestants in turns and keeps the least time of each, because other programs only add to a time.
class Race
{
public:
    using Json = nlohmann::ordered_json;

    Race(osgOffscreen::OffscreenViewer& viewer, const Request& request);

    /// Returns a row for each level with `ms`, `medianMs`, `p99Ms` and `invocations` of each contestant, with
    /// the given number of lights around the model. Where the request's levels move, they do so before each
    /// frame, which plays the steps; the median counts.
    Json run(const std::vector<Contestant>& contestants, const std::vector<std::uint32_t>& levels,
             std::uint32_t mostSteps, int lights, const osg::BoundingSphere& ball);

private:
    double frameMs();
    double shownMs(std::vector<double> times) const;
    void look(const osg::BoundingSphere& ball);

    osgOffscreen::OffscreenViewer& _viewer;
    PipelineCount _count;
    const Request& _request;
};

} // namespace objectbench
