// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <ctime>

#include <viewlod/Budget.h>

namespace viewlod
{

/// The time slice of one frame. Refinement reports each operation to it and asks whether time is left.
/// Reading the thread's clock costs as much as several operations, so it is read only after
/// kBetweenReadingsUs of modelled time.
class Slice
{
public:
    /// Modelled costs of taking one entry from the deferral wheel, of re-evaluating a vertex, and of
    /// splitting or merging a triangle. Their ratio lies between that of measured times and that of counted
    /// instructions (docs/measurements/terrain-refinement.md).
    static constexpr double kHandOutUs = 0.01, kCheckUs = 0.03, kChangeUs = 0.07;

    explicit Slice(const Budget& budget)
        : _limitUs(budget.maxTimeUs), _modelled(budget.clock == Budget::Clock::modelled)
    {
        if (!std::isinf(_limitUs) && !_modelled) _startUs = threadUs();
    }

    /// Report work: entries taken from the wheel, one vertex checked, triangles split or merged.
    void handOut(unsigned watches) { _workUs += kHandOutUs * watches; }
    void check() { _workUs += kCheckUs; }
    void change(unsigned triangles) { _workUs += kChangeUs * triangles; }

    /// Tells whether the slice is used up; once true, it stays true.
    bool isSpent()
    {
        if (_spent || std::isinf(_limitUs)) return _spent;
        if (_modelled) return _spent = _workUs >= _limitUs;
        if (_workUs < _nextReadingUs) return false;
        _nextReadingUs = _workUs + kBetweenReadingsUs;
        return _spent = threadUs() - _startUs >= _limitUs;
    }

    /// Processor time of this thread. Units: microseconds.
    static double threadUs()
    {
        std::timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
    }

private:
    static constexpr double kBetweenReadingsUs = 2.0;

    double _limitUs;
    bool _modelled;
    bool _spent = false;
    double _startUs = 0.0, _workUs = 0.0, _nextReadingUs = 0.0;
};

} // namespace viewlod
