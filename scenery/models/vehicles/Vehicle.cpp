// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/vehicles/Vehicle.h"

#include <array>
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

constexpr std::array kCarTints{glm::vec3(0.72F, 0.10F, 0.09F), glm::vec3(0.80F, 0.81F, 0.83F),
                               glm::vec3(0.93F, 0.93F, 0.92F), glm::vec3(0.16F, 0.17F, 0.19F),
                               glm::vec3(0.15F, 0.26F, 0.48F), glm::vec3(0.42F, 0.44F, 0.47F),
                               glm::vec3(0.20F, 0.34F, 0.26F), glm::vec3(0.62F, 0.56F, 0.46F)};
constexpr std::array kVanTints{glm::vec3(0.93F, 0.93F, 0.92F), glm::vec3(0.93F, 0.93F, 0.92F),
                               glm::vec3(0.88F, 0.72F, 0.20F), glm::vec3(0.25F, 0.38F, 0.58F),
                               glm::vec3(0.60F, 0.62F, 0.64F)};
constexpr std::array kBusTints{glm::vec3(0.85F, 0.67F, 0.15F), glm::vec3(0.75F, 0.16F, 0.13F),
                               glm::vec3(0.90F, 0.90F, 0.88F), glm::vec3(0.20F, 0.42F, 0.58F)};

glm::vec3 tintOf(VehicleKind kind, Dice& dice)
{
    if (isCar(kind)) return dice.oneOf(kCarTints);
    return kind == VehicleKind::van ? dice.oneOf(kVanTints) : dice.oneOf(kBusTints);
}

/// Adds mirrors on short arms: at the foot of a car's A-pillar, in front of a bus.
void addMirrors(ModelBuilder& builder, VehicleKind kind, const StretchedForm& body)
{
    const VehicleForm& form = body.form;
    const VehicleSheet sheet(form);
    const glm::vec2 dark = sheet.darkPx() / static_cast<float>(VehicleSheet::kSheetPx);
    struct Place
    {
        glm::dvec3 foot, head;
        double radiusM, highM;
    };
    const std::array<Place, 3> places{Place{{0.92, 0.84, 0.95}, {0.88, 1.00, 1.00}, 0.075, 0.11},
                                      {{1.62, 0.96, 1.22}, {1.60, 1.16, 1.34}, 0.09, 0.30},
                                      {{5.70, 1.10, 2.62}, {6.05, 1.32, 2.30}, 0.10, 0.34}};
    const Place& place = places[isCar(kind) ? 0 : static_cast<std::size_t>(kind)];
    for (const double side : {1.0, -1.0})
    {
        const auto at = [&](const glm::dvec3& p) { return p * glm::dvec3(1.0, side, 1.0) * body.stretch; };
        builder.begin("mirror", {form.painting, Coat::lacquered});
        addBar(builder, at(place.foot), at(place.head), 0.022, 6, dark);
        const glm::dvec3 head = at(place.head);
        Tube shell{{}, {}, 10, {0.0, 0.0}, 0.0, {}};
        for (const double t : {-1.0, -0.9, -0.6, 0.0, 0.6, 0.9, 1.0})
        {
            shell.line.push_back(head + glm::dvec3(0.0, 0.0, 0.5 * place.highM * t));
            shell.radiiM.push_back(place.radiusM * std::sqrt(1.0 - t * t));
        }
        if (isCar(kind)) // the mirror of a car is wider than high
            for (std::size_t i = 0; i < shell.line.size(); ++i)
                shell.line[i] = head + glm::dvec3(0.0, side * (shell.line[i].z - head.z) * 1.4, 0.0);
        builder.tint(glm::vec3(0.25F));
        addTube(builder, shell);
    }
}

} // namespace

void addVehicleShell(ModelBuilder& builder, VehicleKind kind, const StretchedForm& body,
                     const glm::vec3& tint)
{
    builder.begin("body", {body.form.painting, Coat::lacquered}, tint);
    addBody(builder, body);
    addMirrors(builder, kind, body);
}

Model makeVehicle(VehicleKind kind, std::uint64_t seed)
{
    Dice dice(seed + 60000 + 1000 * static_cast<std::uint64_t>(kind));
    const VehicleForm& form = vehicleForm(kind);
    const StretchedForm body{form,
                             {dice.between(0.96, 1.05), dice.between(0.98, 1.02), dice.between(0.97, 1.05)}};
    const glm::vec3 tint = tintOf(kind, dice);
    ModelBuilder builder;
    addVehicleShell(builder, kind, body, tint);
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
