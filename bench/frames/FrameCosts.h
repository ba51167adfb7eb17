// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "Request.h"
#include "Stage.h"
#include "measurement/Percentile.h"

namespace framebench
{

/// The costs of the frames of one way to draw.
struct FrameCosts
{
    std::vector<double> wallMs, cpuMs;
    double triangles = 0.0; ///< of all frames

    void add(const FrameCost& cost)
    {
        wallMs.push_back(cost.wallMs);
        cpuMs.push_back(cost.cpuMs);
    }

    void appendTo(Report& row) const
    {
        using measurement::percentile;
        row["frames"] = wallMs.size();
        row["triangles"] = triangles / static_cast<double>(wallMs.size());
        row["wallMsP50"] = percentile(wallMs, 0.5);
        row["wallMsP99"] = percentile(wallMs, 0.99);
        row["cpuMsP50"] = percentile(cpuMs, 0.5);
        row["cpuMsP99"] = percentile(cpuMs, 0.99);
    }
};

} // namespace framebench
