// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgPMObjects/core/simplify/ToleranceSearch.h>

namespace osgPMObjects::core
{

ToleranceSearch::ToleranceSearch(const Mesh& mesh, const CollapseSequence& sequence, const LevelMeter& meter)
    : _mesh(mesh), _sequence(sequence), _meter(meter)
{
    std::vector<std::uint32_t> faces{sequence.facesBefore};
    for (const CollapseStep& step : sequence.steps)
        faces.push_back(step.facesAfter);
    for (const std::uint32_t steps : ladderSteps(faces, LadderSettings{}.ratio))
        _ladder.push_back(static_cast<std::uint32_t>(wholeSteps(steps)));
    _ladder.erase(std::unique(_ladder.begin(), _ladder.end()), _ladder.end());
    _errors.resize(_ladder.size());
}

std::size_t ToleranceSearch::coarsestWithin(double tolerance)
{
    for (std::size_t level = _ladder.size(); level-- > 0;)
    {
        std::optional<double>& error = _errors[level];
        if (!error) error = errorAfter(_ladder[level]);
        if (*error > kShare * tolerance) continue;
        return level + 1 < _ladder.size() ? refined(_ladder[level], _ladder[level + 1], tolerance)
                                          : _ladder[level];
    }
    return 0;
}

/// Halves the steps between two levels some times and returns the coarsest level found that keeps the
/// tolerance.
std::size_t ToleranceSearch::refined(std::size_t keeps, std::size_t exceeds, double tolerance) const
{
    constexpr int kHalvings = 5;
    for (int i = 0; i < kHalvings; ++i)
    {
        const std::size_t middle = wholeSteps((keeps + exceeds) / 2);
        if (middle <= keeps) break;
        (errorAfter(middle) <= kShare * tolerance ? keeps : exceeds) = middle;
    }
    return keeps;
}

double ToleranceSearch::errorAfter(std::size_t steps) const
{
    return steps == 0 ? 0.0 : _meter.measure(meshAfter(_mesh, _sequence, steps)).maximum;
}

/// Returns the most steps, at most so many, after which no step is left that belongs to the last one.
std::size_t ToleranceSearch::wholeSteps(std::size_t steps) const
{
    while (steps > 0 && _sequence.steps[steps - 1].goesOn)
        --steps;
    return steps;
}

} // namespace osgPMObjects::core
