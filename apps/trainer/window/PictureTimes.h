// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace trainer
{

/// How long the pictures of a window took so far. Units: ms.
class PictureTimes
{
public:
    /// `processorMs`: of all threads.
    void add(double ms, double processorMs)
    {
        // The first picture makes meshes and compiles shaders.
        if (_count > 0) _processorSumMs += processorMs;
        _lastMs = ms;
        _sumMs += ms;
        _worstMs = std::max(_worstMs, ms);
        ++_count;
    }

    int count() const { return _count; }
    double lastMs() const { return _lastMs; }
    double worstMs() const { return _worstMs; }
    double meanMs() const { return _count > 0 ? _sumMs / _count : 0.0; }
    double meanProcessorMs() const { return _count > 1 ? _processorSumMs / (_count - 1) : 0.0; }

private:
    double _lastMs = 0.0, _worstMs = 0.0, _sumMs = 0.0, _processorSumMs = 0.0;
    int _count = 0;
};

} // namespace trainer
