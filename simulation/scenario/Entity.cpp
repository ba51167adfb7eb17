// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/Entity.h"

#include <charconv>
#include <cmath>
#include <type_traits>

namespace simulation
{

double Controller::number(const std::string& property, double fallback) const
{
    const std::optional<std::string> text = properties.find(property);
    if (!text) return fallback;
    double value = 0.0;
    const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
    return error == std::errc() && end == text->data() + text->size() && std::isfinite(value) ? value
                                                                                              : fallback;
}

namespace
{

/// A member of whichever object there is; the default for an unsupported one.
template<class Member, class Get>
const Member& memberOf(const ScenarioObject& object, Get get)
{
    static const Member none{};
    return std::visit(
        [&](const auto& content) -> const Member&
        {
            if constexpr (std::is_same_v<std::decay_t<decltype(content)>, Unsupported>)
                return none;
            else
                return get(content);
        },
        object.object);
}

} // namespace

std::optional<std::string> Properties::find(const std::string& name) const
{
    for (const auto& [key, value] : values)
        if (key == name) return value;
    return std::nullopt;
}

const BoundingBox& ScenarioObject::box() const
{
    return memberOf<BoundingBox>(*this,
                                 [](const auto& content) -> const BoundingBox& { return content.box; });
}

const Properties& ScenarioObject::properties() const
{
    return memberOf<Properties>(*this,
                                [](const auto& content) -> const Properties& { return content.properties; });
}

const std::string& ScenarioObject::model3d() const
{
    return memberOf<std::string>(*this,
                                 [](const auto& content) -> const std::string& { return content.model3d; });
}

bool ScenarioObject::isAirborne() const
{
    if (const auto* vehicle = std::get_if<Vehicle>(&object))
        if (vehicle->category == "aircraft" || vehicle->category == "helicopter") return true;
    return properties().find("domain") == "air";
}

} // namespace simulation
