// SPDX-License-Identifier: Apache-2.0
// The inside of a car from the driver's seat on its left; vans, buses and lorries have the same without a
// bonnet.
#include <cmath>

#include <foundation/Angle.h>
#include <glm/gtc/matrix_transform.hpp>

#include "scenery/models/cockpit/InstrumentParts.h"
#include "scenery/models/cockpit/InteriorShell.h"
#include "scenery/models/cockpit/SteeringWheel.h"
#include "scenery/models/entities/LookOf.h"

namespace scenery::models
{

namespace
{

// From the eye. Units: metres.
constexpr double kClusterXM = 0.66, kDashTopM = -0.225, kDashEndXM = 1.08, kCarRoofM = 0.24, kWallM = 0.10;
constexpr glm::dvec3 kWheelMiddle(0.42, 0.0, -0.345);
constexpr double kWheelRadiusM = 0.175, kWheelTiltDeg = 24.0;

/// Where the walls are beside the eye.
struct Walls
{
    double leftM, rightM;
};

Walls wallsOf(const EntityShape& shape, const glm::dvec3& eye)
{
    return {0.5 * shape.widthM - eye.y - kWallM, -0.5 * shape.widthM - eye.y + kWallM};
}

Model dashboardModel(const Walls& walls)
{
    ModelBuilder builder;
    builder.begin("dashboard", kPlain, kDashboard);
    box(builder, {kClusterXM + 0.02, walls.rightM, -0.75}, {kDashEndXM, walls.leftM, kDashTopM});
    box(builder, {kClusterXM - 0.03, walls.rightM, -0.75}, {kClusterXM + 0.02, -0.26, kDashTopM - 0.03});
    box(builder, {kClusterXM - 0.03, 0.26, -0.75}, {kClusterXM + 0.02, walls.leftM, kDashTopM - 0.03});
    builder.begin("cluster", kPlain, kSeam);
    box(builder, {kClusterXM, -0.25, -0.42}, {kClusterXM + 0.03, 0.25, kDashTopM});
    box(builder, {kClusterXM - 0.04, -0.22, kDashTopM - 0.012},
        {kClusterXM + 0.05, 0.22, kDashTopM + 0.006}); // its hood
    return builder.finish(30.0);
}

/// Pillars, doors, roof.
Model carCabinModel(const Walls& walls)
{
    ModelBuilder builder;
    builder.begin("cabin", kPlain, kLining);
    for (const double side : {1.0, -1.0})
    {
        const double wall = side > 0.0 ? walls.leftM : walls.rightM, lean = -0.14 * side;
        addPost(builder, {kDashEndXM, wall, kDashTopM - 0.03}, {0.32, wall + lean, kCarRoofM}, 0.03);
        addPost(builder, {-0.25, wall, -0.30}, {-0.30, wall + lean, kCarRoofM}, 0.045);
        addPost(builder, {0.34, wall + lean, kCarRoofM - 0.01}, {-1.4, wall + lean, kCarRoofM - 0.01}, 0.03);
        box(builder, {-1.5, std::min(wall, wall + 0.05 * side), -0.9},
            {kDashEndXM, std::max(wall, wall + 0.05 * side), -0.26});
    }
    box(builder, {-1.4, walls.rightM + 0.13, kCarRoofM}, {0.34, walls.leftM - 0.13, kCarRoofM + 0.03});
    return builder.finish(30.0);
}

/// The bonnet of the form that is drawn from outside, in the entity's frame.
Model bonnetModel(const EntityShape& shape)
{
    const std::shared_ptr<const VehicleLook> look = lookOf(shape);
    const VehicleForm& form = look->form;
    const glm::dvec3 stretch(shape.lengthM / form.lengthM, shape.widthM / form.widthM,
                             shape.heightM / form.heightM);
    ModelBuilder builder;
    builder.begin("bonnet", {Painting::plain, Coat::lacquered}, {shape.red, shape.green, shape.blue});
    constexpr int kAlong = 16, kAcross = 20;
    std::vector<std::vector<Corner>> rows;
    for (int i = kAlong; i >= 0; --i)
    {
        const double x = 1.12 + (0.5 * form.lengthM - 1.12) * i / kAlong;
        std::vector<Corner>& row = rows.emplace_back();
        for (int k = 0; k <= kAcross; ++k)
        {
            const double share = 1.0 - 2.0 * k / kAcross; // from the left to the right
            const double drop = (form.top(x) - form.belt(x) + 0.02) * std::pow(std::abs(share), 3.0);
            row.push_back({glm::dvec3(x, share * form.half(x), form.top(x) - drop) * stretch +
                               glm::dvec3(shape.middleXM, 0.0, 0.0),
                           plainUv()});
        }
    }
    builder.grid(rows);
    return builder.finish(60.0);
}

Model telltaleModel(const std::vector<glm::dvec2>& corners, const glm::vec3& tint)
{
    ModelBuilder builder;
    builder.begin("telltale", kPlain, tint);
    const auto corner = [&](std::size_t i) {
        return Corner{{corners[i], 0.0}, plainUv(), {0.0F, 0.0F, 1.0F}};
    };
    for (std::size_t i = 2; i < corners.size(); ++i)
        builder.triangle(corner(0), corner(i - 1), corner(i));
    return builder.finish();
}

/// Lamps that tell what is on. Frame of their places: the panel's.
void addTelltales(InteriorModel& interior, const glm::dmat4& panel)
{
    const auto add = [&](const char* name, const glm::dvec2& at, const std::vector<glm::dvec2>& shape,
                         const glm::vec3& tint, Reading reading)
    {
        const glm::dmat4 place = glm::translate(panel, {at, kHandLiftM});
        interior.parts.push_back({name, telltaleModel(shape, tint), InteriorCoat::lamp,
                                  [=](const Readings&) { return place; },
                                  [=](const Readings& readings) { return readings[reading] > 0.5; }});
    };
    const double size = 0.009;
    const std::vector<glm::dvec2> left{{-size, 0.0}, {size, -size}, {size, size}},
        right{{size, 0.0}, {-size, size}, {-size, -size}},
        square{{-0.5 * size, -0.5 * size},
               {0.5 * size, -0.5 * size},
               {0.5 * size, 0.5 * size},
               {-0.5 * size, 0.5 * size}};
    add("indicator left", {-0.024, -0.342}, left, {0.15F, 0.95F, 0.2F}, Reading::indicatorLeft);
    add("indicator right", {0.024, -0.342}, right, {0.15F, 0.95F, 0.2F}, Reading::indicatorRight);
    add("head lamps", {0.0, -0.342}, square, {0.2F, 0.9F, 0.3F}, Reading::headLamps);
    add("handbrake", {0.026, -0.370}, square, {0.95F, 0.12F, 0.1F}, Reading::handbrake);
}

void addWheel(InteriorModel& interior, const glm::dvec3& eye)
{
    const glm::dmat4 tilted =
        glm::rotate(upright(eye + kWheelMiddle), -foundation::radiansOf(kWheelTiltDeg), {1.0, 0.0, 0.0});
    interior.parts.push_back({"steering wheel", makeSteeringWheel(kWheelRadiusM), InteriorCoat::inside,
                              [=](const Readings& readings)
                              {
                                  return glm::rotate(
                                      tilted, foundation::radiansOf(readings[Reading::steeringWheelDeg]),
                                      {0.0, 0.0, 1.0});
                              }});
}

void addMirrors(InteriorModel& interior, const Walls& walls, const glm::dvec3& eye)
{
    const auto add =
        [&](const char* name, const glm::dvec3& at, const glm::dvec2& sizeM, const glm::dvec3& seen)
    { addMirror(interior, mirrorTowards(name, eye + at, sizeM, eye, seen)); };
    add("left mirror", {0.82, walls.leftM + 0.13, -0.235}, {0.19, 0.12}, {-1.0, 0.12, -0.035});
    add("right mirror", {0.82, walls.rightM - 0.13, -0.235}, {0.19, 0.12}, {-1.0, -0.12, -0.035});
    add("inner mirror", {0.50, 0.5 * (walls.leftM + walls.rightM), 0.13}, {0.24, 0.062}, {-1.0, 0.0, -0.03});
}

} // namespace

InteriorModel makeCarInterior(const EntityShape& shape, const glm::dvec3& eye)
{
    InteriorModel interior;
    interior.lookDownDeg = 5.0;
    interior.panel = panelViewOf(carPanel(), kClusterXM);
    const Walls walls = wallsOf(shape, eye);
    const auto atEye = movedBy(eye);
    interior.parts.push_back({"dashboard", dashboardModel(walls), InteriorCoat::inside, atEye});
    interior.parts.push_back({"cabin", carCabinModel(walls), InteriorCoat::inside, atEye});
    if (shape.kind == EntityKind::car)
        interior.parts.push_back({"bonnet", bonnetModel(shape), InteriorCoat::outside});
    const glm::dmat4 panel = upright(eye + glm::dvec3(kClusterXM, 0.0, 0.0));
    addInstruments(interior, carPanel(), panel);
    addDrums(interior,
             {"gear",
              {0.0, -0.370, 0.0},
              0.018,
              1,
              DrumColumn::gears,
              [](const Readings& readings)
              { return static_cast<int>(std::lround(readings[Reading::gear])) + 1; }},
             panel);
    addTelltales(interior, panel);
    addWheel(interior, eye);
    addMirrors(interior, walls, eye);
    return interior;
}

} // namespace scenery::models
