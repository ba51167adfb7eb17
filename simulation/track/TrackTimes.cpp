// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TrackTimes.h"

#include <algorithm>
#include <numeric>

namespace simulation
{
namespace
{

constexpr double kHalfDayS = 43200.0, kWholeDayS = 86400.0;
constexpr double kUnsetClockS = 30.0 * kWholeDayS;

void sortParts(std::vector<TrackFix>& fixes, std::span<const std::size_t> parts)
{
    std::vector<std::size_t> begins{0};
    for (const std::size_t part : parts)
        if (part > begins.back() && part < fixes.size()) begins.push_back(part);
    if (begins.size() < 2) return;
    std::vector<std::pair<double, std::size_t>> order; // the middle fix's time, the part
    const auto endOf = [&](std::size_t i) { return i + 1 < begins.size() ? begins[i + 1] : fixes.size(); };
    for (std::size_t i = 0; i < begins.size(); ++i)
        order.emplace_back(fixes[(begins[i] + endOf(i)) / 2].timeS, i);
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<TrackFix> sorted;
    for (const auto& [timeS, i] : order)
        sorted.insert(sorted.end(), fixes.begin() + static_cast<long>(begins[i]),
                      fixes.begin() + static_cast<long>(endOf(i)));
    fixes = std::move(sorted);
}

bool fallsMostly(const std::vector<TrackFix>& fixes)
{
    std::size_t rising = 0, falling = 0;
    for (std::size_t i = 1; i < fixes.size(); ++i)
    {
        rising += fixes[i].timeS > fixes[i - 1].timeS ? 1 : 0;
        falling += fixes[i].timeS < fixes[i - 1].timeS ? 1 : 0;
    }
    return falling >= 2 && falling > 2 * rising;
}

/// For each fix how many can follow it, itself included, with times that rise.
std::vector<std::size_t> longestFrom(const std::vector<TrackFix>& fixes)
{
    std::vector<std::size_t> lengths(fixes.size());
    std::vector<double> latest; // the latest time that begins a sequence of each length, negated: ascending
    for (std::size_t i = fixes.size(); i-- > 0;)
    {
        const auto at = std::lower_bound(latest.begin(), latest.end(), -fixes[i].timeS);
        lengths[i] = static_cast<std::size_t>(at - latest.begin()) + 1;
        if (at == latest.end())
            latest.push_back(-fixes[i].timeS);
        else
            *at = -fixes[i].timeS;
    }
    return lengths;
}

/// The fixes that are kept, in ascending order.
std::vector<std::size_t> risingOf(const std::vector<TrackFix>& fixes)
{
    std::vector<std::size_t> kept;
    if (fixes.empty()) return kept;
    const std::vector<std::size_t> lengths = longestFrom(fixes);
    std::size_t wanted = *std::max_element(lengths.begin(), lengths.end());
    for (std::size_t i = 0; i < fixes.size() && wanted > 0; ++i)
        if (lengths[i] == wanted && (kept.empty() || fixes[i].timeS > fixes[kept.back()].timeS))
        {
            kept.push_back(i);
            --wanted;
        }
    return kept;
}

std::string lineOf(const TrackFix& fix)
{
    return "line " + std::to_string(fix.line);
}

/// Tells of each fix that is not kept against which one its time is wrong.
std::vector<TrackProblem> faultsOf(const std::vector<TrackFix>& fixes, const std::vector<std::size_t>& kept)
{
    std::vector<TrackProblem> faults;
    std::size_t next = 0; ///< of `kept`
    for (std::size_t i = 0; i < fixes.size(); ++i)
    {
        if (next < kept.size() && kept[next] == i)
        {
            ++next;
            continue;
        }
        const bool isEarly = next > 0 && !(fixes[i].timeS > fixes[kept[next - 1]].timeS);
        faults.push_back(
            {fixes[i].line,
             isEarly || next == kept.size()
                 ? "the time is not later than that of " + lineOf(fixes[kept[next > 0 ? next - 1 : 0]])
                 : "the time is not earlier than that of " + lineOf(fixes[kept[next]]) + ", which follows"});
    }
    return faults;
}

/// Drops fixes at both ends that are far from the others in time.
void dropUnset(std::vector<TrackFix>& fixes, std::vector<TrackProblem>& dropped)
{
    if (fixes.size() < 3) return;
    const std::size_t most = std::max<std::size_t>(1, fixes.size() / 10);
    const auto isGap = [&](std::size_t i) { return fixes[i].timeS - fixes[i - 1].timeS > kUnsetClockS; };
    const auto say = [&](const TrackFix& fix) {
        dropped.push_back({fix.line, "the time is more than 30 days from those of the other fixes"});
    };
    std::size_t begin = 0, end = fixes.size();
    for (std::size_t i = 1; i <= most; ++i)
    {
        if (isGap(i)) begin = i;
        if (isGap(fixes.size() - i)) end = fixes.size() - i;
    }
    if (end <= begin + 1) return;
    for (std::size_t i = 0; i < fixes.size(); ++i)
        if (i < begin || i >= end) say(fixes[i]);
    fixes.erase(fixes.begin() + static_cast<long>(end), fixes.end());
    fixes.erase(fixes.begin(), fixes.begin() + static_cast<long>(begin));
}

} // namespace

TimeOrder orderInTime(std::vector<TrackFix>& fixes, std::span<const std::size_t> parts)
{
    TimeOrder order;
    sortParts(fixes, parts);
    if (fallsMostly(fixes))
    {
        std::reverse(fixes.begin(), fixes.end());
        order.isReversed = true;
    }
    const std::vector<std::size_t> kept = risingOf(fixes);
    if (kept.size() < fixes.size())
    {
        order.dropped = faultsOf(fixes, kept);
        for (std::size_t i = 0; i < kept.size(); ++i)
            if (kept[i] != i) fixes[i] = std::move(fixes[kept[i]]);
        fixes.resize(kept.size());
    }
    dropUnset(fixes, order.dropped);
    return order;
}

void addDays(std::vector<TrackFix>& fixes)
{
    double daysS = 0.0, beforeS = 0.0, twoBeforeS = 0.0; // the two fixes before, as they are written
    for (std::size_t i = 0; i < fixes.size(); ++i)
    {
        const double writtenS = fixes[i].timeS;
        const bool falls = i > 0 && writtenS < beforeS - kHalfDayS;
        const bool isNear = writtenS + kWholeDayS - beforeS < 0.5 * kHalfDayS;
        const bool wasLate = i < 2 ? isNear : twoBeforeS > writtenS + kHalfDayS;
        const bool stays = i + 1 == fixes.size() || fixes[i + 1].timeS < beforeS - kHalfDayS;
        if (falls && wasLate && stays) daysS += kWholeDayS;
        twoBeforeS = beforeS;
        beforeS = writtenS;
        fixes[i].timeS += daysS;
    }
}

} // namespace simulation
