// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/vehicles/Vehicle.h"

#include <cmath>

#include "scenery/models/Dice.h"
#include "scenery/models/mesh/Box.h"
#include "scenery/models/mesh/Tube.h"
#include "scenery/models/vehicles/Body.h"
#include "scenery/models/vehicles/Wheel.h"

namespace scenery::models
{

namespace
{

/// Adds mirrors on short arms: at the foot of a car's A-pillar, in front of a bus.
void addMirrors(ModelBuilder& builder, const std::shared_ptr<const VehicleLook>& look,
                const StretchedForm& body)
{
    const VehicleSheet sheet(body.form);
    const glm::vec2 dark = sheet.darkPx() / static_cast<float>(VehicleSheet::kSheetPx);
    const LookMirror& place = look->mirrors;
    for (const double side : {1.0, -1.0})
    {
        const auto at = [&](const glm::dvec3& p) { return p * glm::dvec3(1.0, side, 1.0) * body.stretch; };
        builder.begin("mirror", {Painting::vehicle, Coat::lacquered, look});
        addBar(builder, at(place.foot), at(place.head), 0.022, 6, dark);
        const glm::dvec3 head = at(place.head);
        Tube shell{{}, {}, 10, {0.0, 0.0}, 0.0, {}};
        for (const double t : {-1.0, -0.9, -0.6, 0.0, 0.6, 0.9, 1.0})
        {
            shell.line.push_back(head + glm::dvec3(0.0, 0.0, 0.5 * place.lengthM * t));
            shell.radiiM.push_back(place.radiusM * std::sqrt(1.0 - t * t));
        }
        if (place.isWide)
            for (std::size_t i = 0; i < shell.line.size(); ++i)
                shell.line[i] = head + glm::dvec3(0.0, side * (shell.line[i].z - head.z) * 1.4, 0.0);
        builder.tint(glm::vec3(0.25F));
        addTube(builder, shell);
    }
}

} // namespace

void addVehicleShell(ModelBuilder& builder, const std::shared_ptr<const VehicleLook>& look,
                     const StretchedForm& body, const glm::vec3& tint)
{
    builder.begin("body", {Painting::vehicle, Coat::lacquered, look}, tint);
    addBody(builder, body);
    addMirrors(builder, look, body);
}

Model makeVehicle(const std::shared_ptr<const VehicleLook>& look, std::uint64_t seed)
{
    Dice dice(seed + look->seed);
    const VehicleForm& form = look->form;
    const auto stretch = [&](const StretchRange& range) { return dice.between(range.least, range.most); };
    const StretchedForm body{form, {stretch(look->length), stretch(look->width), stretch(look->height)}};
    const glm::vec3 tint = dice.oneOf(look->colours);
    ModelBuilder builder;
    addVehicleShell(builder, look, body, tint);
    builder.begin("wheels", {Painting::wheel, Coat::matt});
    const double radius = body.wheelRadiusM();
    for (const double axle : {form.axles.x, form.axles.y})
        for (const double side : {1.0, -1.0})
        {
            const double hubY = 0.5 * form.widthM * body.stretch.y * 0.965 - 0.5 * form.wheelWidthM;
            addWheel(builder, {{axle * body.stretch.x, side * hubY, radius}, radius, form.wheelWidthM, side});
        }
    return builder.finish(38.0);
}

} // namespace scenery::models
