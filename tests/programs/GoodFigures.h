// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "compare/terrain/methods/MethodFigures.h"

namespace terraintool
{

/// Made-up figures of methods, of which every requirement and claim holds.
inline DemComparison goodFigures()
{
    MethodFigures good;
    good.name = "vdpm";
    good.triangles = 400.0;
    good.trueErrorPx = 2.0;
    good.adaptUsP50 = 10.0;
    good.adaptUsP99 = good.adaptUsMax = 20.0;
    good.changedPercent = 1.0;
    good.popPx = 0.5;
    good.transformsPerTriangle = 0.8;
    good.spikeTriangles = 20.0;
    good.sideSamples = 129.0;
    good.ceiling = CeilingFigures{1000.0, 1000.0, 0, 0.995, 1.0};
    good.slices = SliceFigures{5, 0};
    good.stripLength = 20.0;
    good.dualStripLength = 30.0;
    good.lightPercent = 1.0;
    good.lightDeg = 2.0;
    good.areaRatio = 64.0;
    good.visiblePercent = 20.0;
    good.followsEdits = true;
    good.memoryMB = 1.0;
    good.morph = MorphFigures{4.0, 3.0, 100.0, 10.0};
    good.fit = FitFigures{1.0, 2.0, 3.0, 20.0, 80.0};
    good.frameMs = 100.0;
    MethodFigures roam = good, blocks = good;
    roam.name = "roam";
    roam.triangles = 1000.0;
    good.fit = FitFigures{1.0, 2.0, 3.0, 80.0, 20.0};
    blocks.name = "blocks";
    blocks.isOfBlocks = true;
    blocks.triangles = 1500.0;
    MethodFigures walk = roam, queue = roam;
    walk.name = "roam-walk";
    queue.name = "roam-queue";
    MethodFigures decimated = blocks, vipm = blocks, overlapping = blocks;
    decimated.name = "regular-decimation";
    decimated.morph->vertices = 500.0;
    decimated.lightDeg = 20.0;
    vipm.name = "vipm-locked";
    overlapping.name = "vipm-overlapping";
    overlapping.triangles = 1400.0;
    DemComparison dem{
        "made up", {good, roam, blocks, decimated, vipm, overlapping, walk, queue}, {10.0, 50.0}, {}};
    for (const auto& [way, us] :
         {std::pair{"wheel", 1.0}, {"enhMerge", 2.0}, {"one by one", 3.0}, {"restart", 4.0}})
        for (const bool inSight : {false, true})
            dem.reworks.push_back({inSight ? "jump, in sight" : "jump", way, inSight, us, us, 10.0});
    return dem;
}

} // namespace terraintool
