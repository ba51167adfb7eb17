// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/LaneLists.h"

#include <algorithm>
#include <initializer_list>
#include <span>
#include <utility>

namespace worldmaking
{

namespace
{

using Entries = std::vector<std::string_view>;

/// The first of some lists that has an entry for a lane, and that entry.
std::string_view entryOf(std::span<const Entries> lists, std::size_t lane)
{
    for (const Entries& list : lists)
        if (lane < list.size() && !list[lane].empty()) return list[lane];
    return {};
}

bool isInAny(std::span<const Entries> lists, std::size_t lane, std::initializer_list<std::string_view> words)
{
    return std::any_of(lists.begin(), lists.end(),
                       [&](const Entries& list) {
                           return lane < list.size() &&
                                  std::find(words.begin(), words.end(), list[lane]) != words.end();
                       });
}

/// The lists of access of a direction.
struct AccessLists
{
    std::vector<Entries> cars, buses, bicycles;

    AccessLists(const Tags& tags, const std::string& side)
        : cars(listsOf(tags, side,
                       {"motorcar:lanes", "motor_vehicle:lanes", "vehicle:lanes", "access:lanes"})),
          buses(listsOf(tags, side, {"bus:lanes", "psv:lanes"})),
          bicycles(listsOf(tags, side, {"bicycle:lanes"}))
    {
    }

    std::size_t lanes() const
    {
        std::size_t most = 0;
        for (const auto* lists : {&cars, &buses, &bicycles})
            for (const Entries& list : *lists)
                most = std::max(most, list.size());
        return most;
    }

    LaneUse useOf(std::size_t lane) const
    {
        const std::string_view ofCars = entryOf(cars, lane);
        if (isInAny(buses, lane, {"designated", "official"})) return LaneUse::buses;
        const bool isOpen = !ofCars.empty() && ofCars != "no";
        if (!isOpen && isInAny(bicycles, lane, {"designated", "official"})) return LaneUse::bicycles;
        if (ofCars != "no") return LaneUse::cars;
        if (isInAny(buses, lane, {"yes", "permissive"})) return LaneUse::buses;
        return isInAny(bicycles, lane, {"yes", "permissive"}) ? LaneUse::bicycles : LaneUse::others;
    }

private:
    static std::vector<Entries> listsOf(const Tags& tags, const std::string& side,
                                        std::initializer_list<const char*> keys)
    {
        std::vector<Entries> lists;
        for (const char* key : keys)
            lists.push_back(laneEntries(tags, key + side));
        return lists;
    }
};

} // namespace

std::vector<std::string_view> laneEntries(const Tags& tags, const std::string& key)
{
    Entries entries;
    std::string_view rest = valueOf(tags, key);
    if (rest.empty()) return entries;
    for (std::size_t bar = rest.find('|'); bar != std::string_view::npos; bar = rest.find('|'))
    {
        entries.push_back(rest.substr(0, bar));
        rest.remove_prefix(bar + 1);
    }
    entries.push_back(rest);
    return entries;
}

std::vector<LaneUse> laneUsesOf(const Tags& tags, const std::string& side)
{
    const AccessLists lists(tags, side);
    std::vector<LaneUse> uses;
    if (lists.lanes() > kMostListed) return uses;
    for (std::size_t lane = 0; lane < lists.lanes(); ++lane)
        uses.push_back(lists.useOf(lane));
    return uses;
}

std::vector<LaneUse> withoutBicycles(std::vector<LaneUse> uses)
{
    std::erase(uses, LaneUse::bicycles);
    return uses;
}

} // namespace worldmaking
