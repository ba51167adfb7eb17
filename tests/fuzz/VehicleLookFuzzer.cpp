// SPDX-License-Identifier: Apache-2.0
// Any text may be given as the look of a vehicle: it becomes one whose model is sound and whose sheet can be
// painted, or is refused with place and remedy.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "scenery/models/ModelCheck.h"
#include "scenery/models/Paint.h"
#include "scenery/models/looks/VehicleLookFile.h"
#include "scenery/models/vehicles/Vehicle.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace scenery::models;
    const auto read = parseVehicleLook({reinterpret_cast<const char*>(data), size}, "fuzz.json");
    if (!read)
    {
        if (!read.error().place.starts_with("fuzz.json") || read.error().remedy.empty()) std::abort();
        return 0;
    }
    const auto look = std::make_shared<const VehicleLook>(*read);
    if (look->name.empty() || look->colours.empty()) std::abort();
    const Model model = makeVehicle(look, 1);
    if (!isModel(model) || !isClosed(model.mesh, "body")) std::abort();
    std::size_t marks = 0;
    for (const auto& view : look->paint)
        for (const LookMark& mark : view)
            marks += static_cast<std::size_t>(mark.repeats);
    constexpr std::size_t kFewMarks = 4; // painting all takes long
    if (marks <= kFewMarks && paint(Painting::vehicle, look.get()).rgba.empty()) std::abort();
    return 0;
}
