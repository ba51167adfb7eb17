// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <foundation/XmlFields.h>

#include <osgRoads/core/geometry/Cubic.h>
#include <osgRoads/core/network/LaneType.h>

namespace osgRoads::core
{

using foundation::set;

/// The word of OpenDRIVE for a value.
template<class Value, std::size_t Count>
std::string_view keyword(const Keywords<Value, Count>& words, Value value)
{
    for (const auto& [word, meaning] : words)
        if (meaning == value) return word;
    return {};
}

/// Writes where an object or a signal is at its road, and for which direction it holds.
template<class Thing>
void writePlace(pugi::xml_node node, const Thing& thing)
{
    set(node, "s", thing.s);
    set(node, "t", thing.t);
    set(node, "zOffset", thing.zOffset);
    set(node, "orientation", thing.orientation == '0' ? "none" : std::string(1, thing.orientation));
}

/// Writes an element for each piece of a profile. `start`: the name of its beginning, s or sOffset.
inline void writeProfile(pugi::xml_node parent, const char* name, const char* start,
                         const CubicProfile& profile)
{
    for (const Cubic& piece : profile.pieces())
    {
        const pugi::xml_node node = parent.append_child(name);
        set(node, start, piece.s);
        set(node, "a", piece.a);
        set(node, "b", piece.b);
        set(node, "c", piece.c);
        set(node, "d", piece.d);
    }
}

} // namespace osgRoads::core
