// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/scenario/ControllerProperties.h"

#include <algorithm>

#include <foundation/Excerpt.h>

#include "simulation/parser/Expression.h"

namespace simulation
{

ControllerProperties::ControllerProperties(const Controller& controller, std::filesystem::path folder,
                                           const std::vector<std::string_view>& names)
    : _controller(controller), _folder(std::move(folder))
{
    for (const auto& [name, value] : controller.properties.values)
    {
        const bool isKnown = name == "kind" || name == "esminiController" ||
                             std::find(names.begin(), names.end(), name) != names.end();
        if (isKnown) continue;
        std::string all;
        for (const std::string_view known : names)
            all += (all.empty() ? "" : ", ") + std::string(known);
        fail(name, "is not known for " + controller.kind(), "write one of: " + all);
    }
}

void ControllerProperties::fail(std::string_view name, const std::string& what, const std::string& remedy)
{
    if (!_error) _error = foundation::Error{"property " + foundation::excerpt(name), what, remedy};
}

std::string ControllerProperties::text(std::string_view name, const std::string& fallback) const
{
    return _controller.properties.find(std::string(name)).value_or(fallback);
}

double ControllerProperties::number(std::string_view name, double fallback, double least, double most)
{
    const auto value = _controller.properties.find(std::string(name));
    if (!value) return fallback;
    const auto number = parseNumber(*value);
    if (number && *number >= least && *number <= most) return *number;
    fail(name, "is '" + foundation::excerpt(*value) + "'",
         "write a number from " + formatNumber(least) + " to " + formatNumber(most));
    return fallback;
}

std::vector<double> ControllerProperties::numbers(std::string_view name, std::size_t least, std::size_t most)
{
    const auto value = _controller.properties.find(std::string(name));
    if (!value) return {};
    std::vector<double> numbers;
    std::string_view rest = *value;
    bool isSound = true;
    while (isSound)
    {
        const std::size_t end = std::min(rest.find(','), rest.size());
        const auto number = parseNumber(rest.substr(0, end));
        isSound = number.has_value();
        if (isSound) numbers.push_back(*number);
        if (end == rest.size()) break;
        rest.remove_prefix(end + 1);
    }
    if (isSound && numbers.size() >= least && numbers.size() <= most) return numbers;
    fail(name, "is '" + foundation::excerpt(*value) + "'",
         "write " + std::to_string(least) + (most > least ? " to " + std::to_string(most) : "") +
             " numbers parted by commas");
    return {};
}

bool ControllerProperties::flag(std::string_view name, bool fallback)
{
    const auto value = _controller.properties.find(std::string(name));
    if (!value) return fallback;
    if (*value == "true" || *value == "false") return *value == "true";
    fail(name, "is '" + foundation::excerpt(*value) + "'", "write true or false");
    return fallback;
}

std::filesystem::path ControllerProperties::file(std::string_view name, const std::filesystem::path& fallback)
{
    const auto value = _controller.properties.find(std::string(name));
    if (!value) return fallback;
    std::error_code ignored;
    const std::filesystem::path beside = _folder / *value;
    return std::filesystem::exists(beside, ignored) || !std::filesystem::exists(*value, ignored)
               ? beside
               : std::filesystem::path(*value);
}

} // namespace simulation
