// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/InputTrack.h"

#include <algorithm>

#include "simulation/parser/Expression.h"

namespace simulation
{

void InputTrack::valuesAt(double place, std::span<double> values) const
{
    const auto next = std::upper_bound(rows.begin(), rows.end(), place,
                                       [](double p, const Row& row) { return p < row.at; });
    if (next == rows.begin())
    {
        std::fill(values.begin(), values.end(), kInputNotGiven);
        return;
    }
    const Row& from = *std::prev(next);
    std::copy(from.values.begin(), from.values.end(), values.begin());
    if (!isRamped || next == rows.end()) return;
    const double share = (place - from.at) / (next->at - from.at);
    for (std::size_t i = 0; i < from.values.size(); ++i)
        if (from.values[i] != kInputNotGiven && next->values[i] != kInputNotGiven)
            values[i] += share * (next->values[i] - from.values[i]);
}

std::string writeInputs(const InputTrack& track)
{
    std::string text = "osgtrainer-inputs 1\n";
    if (track.stepsPerSecond > 0) text += "rate " + std::to_string(track.stepsPerSecond) + "\n";
    if (track.isRamped) text += "ramped\n";
    text += track.stepsPerSecond > 0 ? "columns step" : "columns time";
    for (const std::string& name : track.names)
        text += " " + name;
    text += "\n";
    for (const InputTrack::Row& row : track.rows)
    {
        text += formatNumber(row.at);
        for (const double value : row.values)
            text += value == kInputNotGiven ? " -" : " " + formatNumber(value);
        text += "\n";
    }
    if (track.end) text += "end " + formatNumber(*track.end) + "\n";
    return text;
}

} // namespace simulation
