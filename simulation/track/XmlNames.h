// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include <pugixml.hpp>

#include "simulation/environment/DateTime.h"
#include "simulation/track/TrackBuilder.h"

/// Elements by their names without the prefix of a namespace.
namespace simulation
{

inline std::string_view plainName(pugi::xml_node node)
{
    const std::string_view name = node.name();
    const std::size_t colon = name.rfind(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

/// Returns the first child of a name, or none.
inline pugi::xml_node childOf(pugi::xml_node parent, std::string_view name)
{
    for (pugi::xml_node child : parent.children())
        if (plainName(child) == name) return child;
    return {};
}

inline std::string_view textOf(pugi::xml_node parent, std::string_view name)
{
    return trimmed(childOf(parent, name).text().get());
}

/// Returns the seconds since 1970 of a date and time; nothing where it cannot be read.
inline std::optional<double> unixSeconds(std::string_view text)
{
    const auto time = parseDateTime(trimmed(text));
    if (!time) return std::nullopt;
    return static_cast<double>(time->unixMilliseconds) / 1000.0;
}

inline std::string_view withoutMark(std::string_view text)
{
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

} // namespace simulation
