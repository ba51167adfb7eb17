// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osgMultiTriangulation/core/input/TinFile.h>

namespace osgMultiTriangulation::core
{

/// Hands points and triangles on to a sink, which must outlive it, and counts them.
class CountedSink
{
public:
    explicit CountedSink(TinSink& sink) : _sink(sink) {}

    void add(const MeasuredPoint& point)
    {
        _sink.add(point);
        ++_points;
    }

    void add(const Triangle& triangle)
    {
        _sink.add(triangle);
        ++_triangles;
    }

    std::uint64_t points() const { return _points; }
    std::uint64_t triangles() const { return _triangles; }

private:
    TinSink& _sink;
    std::uint64_t _points = 0, _triangles = 0;
};

} // namespace osgMultiTriangulation::core
