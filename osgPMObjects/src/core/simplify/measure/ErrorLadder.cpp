// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <foundation/SettingsCheck.h>

#include <osgPMObjects/core/simplify/ErrorLadder.h>

namespace osgPMObjects::core
{

bool areMeasured(std::span<const MeasuredLevel> levels)
{
    const auto isError = [](float error) { return std::isfinite(error) && error >= 0.0f; };
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
        if (i == 0 ? levels[i].steps != 0 : levels[i].steps <= levels[i - 1].steps) return false;
        if (!isError(levels[i].error.maximum) || !isError(levels[i].error.rootMeanSquare)) return false;
    }
    return true;
}

foundation::Outcome checkSettings(const LadderSettings& settings)
{
    return foundation::SettingsCheck("ladder")
        .above("ratio", settings.ratio, 1.0, LadderSettings::kMostRatio)
        .within("samples", settings.samples, LadderSettings::kLeastSamples, LadderSettings::kMostSamples)
        .outcome();
}

std::vector<std::uint32_t> ladderSteps(std::span<const std::uint32_t> faces, double ratio)
{
    std::vector<std::uint32_t> steps;
    const auto lastWith = [&](double least) // the last level with at least so many faces
    {
        const auto fewer =
            std::partition_point(faces.begin(), faces.end(), [=](std::uint32_t f) { return f >= least; });
        return static_cast<std::uint32_t>(fewer - faces.begin()) - 1;
    };
    for (std::uint32_t level = 0; level < faces.size() && faces[level] > 0;)
    {
        steps.push_back(level);
        const std::uint32_t same = lastWith(faces[level]), next = lastWith(faces[level] / ratio);
        if (next > same)
            level = next;
        else if (same + 1 < faces.size()) // one step removes more
            level = lastWith(faces[same + 1]);
        else
            break;
    }
    return steps;
}

ErrorLadder::ErrorLadder(std::vector<MeasuredLevel> levels)
    : _levels(std::move(levels)), _least(_levels.size())
{
    std::array<float, kErrorKinds> least;
    least.fill(std::numeric_limits<float>::infinity());
    for (std::size_t i = _levels.size(); i-- > 0;)
    {
        for (std::size_t kind = 0; kind < kErrorKinds; ++kind)
            least[kind] = std::min(least[kind], _levels[i].error.of(static_cast<ErrorKind>(kind)));
        _least[i] = least;
    }
}

std::size_t ErrorLadder::levelOf(std::uint32_t steps) const
{
    const auto level = std::partition_point(_levels.begin(), _levels.end(),
                                            [=](const MeasuredLevel& l) { return l.steps < steps; });
    return static_cast<std::size_t>(level - _levels.begin());
}

float ErrorLadder::errorAfter(std::uint32_t steps, ErrorKind kind) const
{
    const std::size_t level = levelOf(steps);
    return level < _levels.size() ? _levels[level].error.of(kind) : std::numeric_limits<float>::infinity();
}

std::uint32_t ErrorLadder::coarsestWithin(double tolerance, ErrorKind kind, std::uint32_t most) const
{
    const auto beyond = std::partition_point(_least.begin(), _least.end(),
                                             [&](const auto& least)
                                             { return least[static_cast<std::size_t>(kind)] <= tolerance; });
    if (beyond == _least.begin()) return 0;
    std::size_t level = static_cast<std::size_t>(beyond - _least.begin()) - 1;
    if (_levels[level].steps <= most) return _levels[level].steps;
    if (errorAfter(most, kind) <= tolerance) return most;
    for (level = levelOf(most); level-- > 0;)
        if (_levels[level].error.of(kind) <= tolerance) return _levels[level].steps;
    return 0;
}

} // namespace osgPMObjects::core
