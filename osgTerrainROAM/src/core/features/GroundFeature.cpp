// SPDX-License-Identifier: Apache-2.0
#include <iterator>
#include <utility>

#include <osgTerrainROAM/core/features/GroundFeature.h>

namespace osgTerrainROAM::core
{

std::string FeatureReport::message() const
{
    std::string text = std::to_string(taken) + " of " + std::to_string(read) + " features painted";
    if (outside) text += "; " + std::to_string(outside) + " outside";
    if (invalid) text += "; " + std::to_string(invalid) + " invalid";
    std::size_t strangers = 0;
    std::string names;
    for (const auto& [name, count] : unknown)
    {
        strangers += count;
        names += (names.empty() ? " " : ", ") + name + " " + std::to_string(count);
    }
    if (strangers) text += "; " + std::to_string(strangers) + " unknown:" + names;
    return text;
}

void FeatureSet::append(FeatureSet other)
{
    features.insert(features.end(), std::make_move_iterator(other.features.begin()),
                    std::make_move_iterator(other.features.end()));
    report.read += other.report.read;
    report.taken += other.report.taken;
    report.outside += other.report.outside;
    report.invalid += other.report.invalid;
    report.notes.insert(report.notes.end(), other.report.notes.begin(), other.report.notes.end());
    for (const auto& [name, count] : other.report.unknown)
        report.unknown[name] += count;
}

} // namespace osgTerrainROAM::core
