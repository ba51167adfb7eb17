// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgMultiTriangulation/core/input/TinFile.h>

namespace osgMultiTriangulation::core
{

/// Keeps all that a file has.
struct TinCollector : TinSink
{
    void add(const MeasuredPoint& point) override { tin.points.push_back(point); }
    void add(const Triangle& triangle) override { tin.triangles.push_back(triangle); }

    MeasuredTin tin;
};

} // namespace osgMultiTriangulation::core
