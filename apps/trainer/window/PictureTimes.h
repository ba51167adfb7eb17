// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace trainer
{

/// How long the pictures of a window took so far. Units: ms.
class PictureTimes
{
public:
    void add(double ms)
    {
        _lastMs = ms;
        _sumMs += ms;
        _worstMs = std::max(_worstMs, ms);
        ++_count;
    }

    int count() const { return _count; }
    double lastMs() const { return _lastMs; }
    double worstMs() const { return _worstMs; }
    double meanMs() const { return _count > 0 ? _sumMs / _count : 0.0; }

private:
    double _lastMs = 0.0, _worstMs = 0.0, _sumMs = 0.0;
    int _count = 0;
};

} // namespace trainer
