// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/looks/BuiltInLooks.h"

#include <algorithm>
#include <array>
#include <cassert>

#include <texts/vehicle_looks.h>

#include "scenery/models/looks/VehicleLookFile.h"

namespace scenery::models
{

namespace
{

struct BuiltIn
{
    std::string_view name, text;
};

constexpr std::size_t kLookCount = 4;

const std::array<BuiltIn, kLookCount>& builtIns()
{
    using namespace vehicle_looks::texts;
    static const std::array<BuiltIn, kLookCount> kAll{
        {{"saloon", kSaloon}, {"estate", kEstate}, {"van", kVan}, {"bus", kBus}}};
    return kAll;
}

using LookPointers = std::array<std::shared_ptr<const VehicleLook>, kLookCount>;

LookPointers readBuiltIns()
{
    LookPointers looks;
    for (std::size_t i = 0; i < kLookCount; ++i)
    {
        auto look = parseVehicleLook(builtIns()[i].text, std::string(builtIns()[i].name) + ".json");
        assert(look && "a built-in look is at fault; the test BuiltInLooks names the fault");
        looks[i] = std::make_shared<const VehicleLook>(*std::move(look));
    }
    return looks;
}

} // namespace

std::vector<std::string_view> builtInLookNames()
{
    std::vector<std::string_view> names;
    for (const BuiltIn& look : builtIns())
        names.push_back(look.name);
    return names;
}

std::string_view builtInLookText(std::string_view name)
{
    for (const BuiltIn& look : builtIns())
        if (look.name == name) return look.text;
    return {};
}

std::shared_ptr<const VehicleLook> builtInLook(std::string_view name)
{
    static const LookPointers looks = readBuiltIns();
    const auto found =
        std::find_if(looks.begin(), looks.end(), [&](const auto& look) { return look->name == name; });
    assert(found != looks.end());
    return *found;
}

} // namespace scenery::models
