// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "scenery/models/entities/EntityGenerators.h"
#include "scenery/models/entities/Loft.h"
#include "scenery/models/entities/RollingParts.h"
#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

constexpr glm::vec3 kChassis(0.10F, 0.10F, 0.11F), kGlass(0.08F, 0.10F, 0.12F), kCargo(0.86F, 0.87F, 0.87F),
    kLens(0.88F, 0.89F, 0.90F), kRed(0.55F, 0.03F, 0.04F), kSteel(0.55F, 0.56F, 0.57F);
constexpr double kRakeM = 0.34; ///< how far the roof's edge stands behind the foot of the windscreen
const Surface kLacquer{Painting::plain, Coat::lacquered};

double cabLength(const EntityShape& shape)
{
    return std::min(2.2, 0.4 * shape.lengthM);
}

/// The lower edge of cab, cargo and chassis.
double floorOf(const EntityShape& shape)
{
    return shape.axles.empty() ? 0.25 * shape.heightM : 1.35 * shape.axles.front().wheelRadiusM;
}

/// A plate in front of a face that looks ahead, a little proud of it.
void addPlateAhead(ModelBuilder& builder, double x, const glm::dvec2& yz, const glm::dvec2& size)
{
    box(builder, {x, yz.x - 0.5 * size.x, yz.y - 0.5 * size.y},
        {x + 0.015, yz.x + 0.5 * size.x, yz.y + 0.5 * size.y});
}

/// Two lamps, one on each side; `at`: the left one's middle.
struct LampPair
{
    EntityLamp::Kind left, right;
    glm::dvec3 at;
    glm::dvec2 size;
    bool looksAhead;
};

void addLampPair(ModelBuilder& builder, EntityModel& model, const LampPair& pair)
{
    const auto& [left, right, at, size, looksAhead] = pair;
    for (const double side : {1.0, -1.0})
    {
        const glm::dvec3 middle(at.x, side * at.y, at.z);
        addPlateAhead(builder, looksAhead ? at.x : at.x - 0.015, {middle.y, middle.z}, size);
        model.lamps.push_back({side > 0.0 ? left : right,
                               middle + glm::dvec3(looksAhead ? 0.025 : -0.025, 0.0, 0.0), looksAhead, size.x,
                               size.y});
    }
}

/// Adds a raked pane between its lower and upper edge (x and z), 4 cm thick.
void addWindscreen(ModelBuilder& builder, const glm::dvec2& low, const glm::dvec2& high, double half)
{
    const std::array<glm::dvec2, 4> profile{low, high, high - glm::dvec2(0.04, 0.0),
                                            low - glm::dvec2(0.04, 0.0)};
    addPrism(builder, profile.size(),
             [&](std::size_t end, std::size_t point, std::size_t)
             {
                 const glm::dvec2& at = profile[point];
                 return Corner{{at.x, end == 0 ? half : -half, at.y}, plainUv()};
             });
}

void addCab(ModelBuilder& builder, EntityModel& model, const EntityShape& shape)
{
    using Lamp = EntityLamp::Kind;
    const double front = shape.frontXM(), back = front - cabLength(shape), low = 0.75 * floorOf(shape);
    const double high = std::min(shape.heightM, 3.1), half = 0.49 * shape.widthM;
    const double sill = low + 0.50 * (high - low), lintel = low + 0.90 * (high - low);
    builder.begin("cab", kLacquer, {shape.red, shape.green, shape.blue});
    addHull(builder, {{back, half, low + 0.25, high - 0.02},
                      {back + 0.1, half, low + 0.2, high},
                      {front - kRakeM - 0.12, half, low, high},
                      {front - kRakeM, 0.995 * half, low, high - 0.05},
                      {front - 0.04, 0.97 * half, low + 0.02, sill + 0.06},
                      {front, 0.95 * half, low + 0.05, sill}});
    builder.begin("windscreen", kLacquer, kGlass);
    addWindscreen(builder, {front + 0.02, sill + 0.04}, {front - kRakeM * 0.9 + 0.02, lintel}, 0.86 * half);
    builder.begin("side windows", kLacquer, kGlass);
    box(builder, {front - 1.45, -half - 0.012, sill + 0.02}, {front - 0.55, half + 0.012, lintel - 0.06});
    builder.begin("grille", kPlain, kChassis);
    addPlateAhead(builder, front, {0.0, low + 0.30 * (high - low)}, {1.0 * half, 0.22 * (high - low)});
    builder.begin("bumper", kPlain, kChassis);
    box(builder, {front - 0.3, -half, low - 0.22}, {front + 0.03, half, low + 0.02});
    builder.begin("head lamps", kPlain, kLens);
    addLampPair(builder, model,
                {Lamp::head, Lamp::head, {front + 0.005, 0.76 * half, low + 0.14}, {0.34, 0.16}, true});
    addLampPair(builder, model,
                {Lamp::indicatorLeft,
                 Lamp::indicatorRight,
                 {front + 0.005, 0.62 * half, low + 0.30},
                 {0.12, 0.08},
                 true});
    builder.begin("mirrors", kPlain, kChassis);
    for (const double side : {1.0, -1.0})
    {
        const double y = side * (half + 0.16);
        box(builder, {front - 0.42, y - 0.05, sill + 0.1}, {front - 0.30, y + 0.05, sill + 0.55});
        bar(builder, {front - 0.36, side * (half - 0.05), sill + 0.5}, {front - 0.36, y, sill + 0.5}, 0.02);
    }
    model.eye = {front - 1.0, 0.25 * shape.widthM, sill + 0.35};
}

void addChassis(ModelBuilder& builder, const EntityShape& shape, double fromXM, double toXM)
{
    const double floor = floorOf(shape),
                 radius = shape.axles.empty() ? 0.4 : shape.axles.front().wheelRadiusM;
    builder.begin("frame", kPlain, kChassis);
    for (const double side : {1.0, -1.0})
        box(builder, {fromXM, side * 0.42 - 0.06, 0.72 * floor}, {toXM, side * 0.42 + 0.06, floor});
    if (shape.axles.size() > 1 && toXM - fromXM > 2.5) // tanks between the axles
    {
        const double middle = 0.5 * (shape.axles[0].xM + shape.axles[1].xM);
        for (const double side : {1.0, -1.0})
            addLimb(builder, {middle - 0.35, side * 0.36 * shape.widthM, 0.62 * floor},
                    {middle + 0.35, side * 0.36 * shape.widthM, 0.62 * floor}, 0.25, 0.25);
    }
    for (const AxleShape& axle : shape.axles)
        bar(builder, {axle.xM, -0.45 * shape.widthM, radius}, {axle.xM, 0.45 * shape.widthM, radius}, 0.07);
}

void addTail(ModelBuilder& builder, EntityModel& model, const EntityShape& shape)
{
    using Lamp = EntityLamp::Kind;
    const double back = shape.backXM(), z = 0.78 * floorOf(shape), half = 0.5 * shape.widthM;
    builder.begin("rear beam", kPlain, kChassis);
    box(builder, {back, -0.95 * half, z - 0.12}, {back + 0.1, 0.95 * half, z + 0.12});
    builder.begin("tail lamps", kPlain, kRed);
    addLampPair(builder, model, {Lamp::tail, Lamp::tail, {back, 0.82 * half, z - 0.04}, {0.22, 0.07}, false});
    addLampPair(builder, model,
                {Lamp::brake, Lamp::brake, {back, 0.82 * half, z + 0.05}, {0.22, 0.07}, false});
    builder.begin("rear indicators", kPlain, {0.75F, 0.38F, 0.05F});
    addLampPair(builder, model,
                {Lamp::indicatorLeft, Lamp::indicatorRight, {back, 0.62 * half, z}, {0.12, 0.10}, false});
}

void addCargo(ModelBuilder& builder, const EntityShape& shape, double fromXM, double toXM)
{
    const double floor = floorOf(shape), half = 0.5 * shape.widthM;
    builder.begin("cargo", kPlain, kCargo);
    addHull(builder, {{fromXM, half, floor, shape.heightM}, {toXM, half, floor, shape.heightM}}, 60.0);
    builder.begin("rails", kPlain, kSteel);
    for (const double side : {1.0, -1.0})
        box(builder, {fromXM + 0.02, side * half - 0.02, floor - 0.10},
            {toXM - 0.02, side * half + 0.02, floor + 0.02});
    builder.begin("doors", kPlain, kSteel);
    for (const double y : {-0.55 * half, -0.1 * half, 0.1 * half, 0.55 * half}) // locking bars
        bar(builder, {fromXM - 0.02, y, floor + 0.1}, {fromXM - 0.02, y, shape.heightM - 0.1}, 0.02);
}

/// A trailer whose wheels stand behind the middle, with a drawbar in front.
void addDrawbar(ModelBuilder& builder, const EntityShape& shape)
{
    const double z = 0.8 * floorOf(shape), front = shape.frontXM();
    builder.begin("drawbar", kPlain, kChassis);
    for (const double side : {1.0, -1.0})
        bar(builder, {front - 1.1, side * 0.3 * shape.widthM, z}, {front, side * 0.03, z}, 0.04);
}

} // namespace

EntityModel makeLorry(const EntityShape& shape)
{
    constexpr double kTyreM = 0.30;
    EntityModel model;
    ModelBuilder builder;
    const bool hasCab = shape.kind == EntityKind::lorry || shape.kind == EntityKind::tractor;
    const double cargoFront = hasCab                              ? shape.frontXM() - cabLength(shape) - 0.15
                              : shape.kind == EntityKind::trailer ? shape.frontXM() - 1.0
                                                                  : shape.frontXM();
    if (hasCab) addCab(builder, model, shape);
    addChassis(builder, shape, shape.backXM() + 0.05, hasCab ? shape.frontXM() - 0.5 : cargoFront);
    if (shape.kind != EntityKind::tractor) addCargo(builder, shape, shape.backXM() + 0.04, cargoFront);
    if (shape.kind == EntityKind::trailer) addDrawbar(builder, shape);
    if (shape.kind == EntityKind::tractor)
    {
        builder.begin("fifth wheel", kPlain, kChassis);
        const double z = floorOf(shape);
        addLoft(builder,
                {{{0.0, 0.0, z}, {}, {}},
                 {{0.0, 0.0, z}, {0.45, 0.0, 0.0}, {0.0, 0.45, 0.0}},
                 {{0.0, 0.0, z + 0.08}, {0.45, 0.0, 0.0}, {0.0, 0.45, 0.0}},
                 {{0.0, 0.0, z + 0.08}, {}, {}}},
                16);
    }
    addTail(builder, model, shape);
    model.parts = {model.addMesh(builder.finish())};
    const bool isHeavy = shape.widthM > 2.2;
    addWheels(model, shape, glm::dmat4(1.0), isHeavy ? kTyreM : 0.2, isHeavy && hasCab ? 1 : 1000);
    return model;
}

} // namespace scenery::models
