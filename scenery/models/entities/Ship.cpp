// SPDX-License-Identifier: Apache-2.0
// A cargo ship from 25 m of length on, below that a motor boat. Origin: in the plane of the water, at the
// middle of its length.
#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "scenery/models/entities/EntityGenerators.h"
#include "scenery/models/entities/Loft.h"
#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

constexpr double kSmallestShipM = 25.0;
const Surface kShipPaint{Painting::plain, Coat::lacquered};
constexpr glm::vec3 kWhiteShip(0.90F, 0.90F, 0.88F), kGlassOfShip(0.08F, 0.10F, 0.12F),
    kDeck(0.42F, 0.36F, 0.30F);

/// A hull from its stern to its bow: shares of length and width, its lower edge (the keel) and its sheer as
/// shares of the freeboard.
struct HullStation
{
    double along, wide, keel, sheer;
};

void addShipHull(ModelBuilder& builder, const EntityShape& shape, double freeboardM, double draughtM)
{
    const std::array<HullStation, 8> stations{{{-0.50, 0.82, -0.1, 1.04},
                                               {-0.46, 0.90, 0.55, 1.02},
                                               {-0.30, 1.0, 1.0, 1.0},
                                               {0.15, 1.0, 1.0, 1.0},
                                               {0.32, 0.86, 1.0, 1.06},
                                               {0.42, 0.55, 0.95, 1.16},
                                               {0.475, 0.24, 0.7, 1.26},
                                               {0.50, 0.03, -0.6, 1.32}}};
    std::vector<std::vector<Corner>> rows;
    const auto at = [&](const HullStation& s, double wide, double z) {
        return Corner{{s.along * shape.lengthM, wide * s.wide * 0.5 * shape.widthM, z}, plainUv()};
    };
    const auto ring = [&](const HullStation& s, double share)
    {
        const double top = s.sheer * freeboardM, keel = -s.keel * draughtM;
        return std::vector<Corner>{
            at(s, 0.92 * share, 0.4 * top + 0.6 * keel),  at(s, share, top),         at(s, -share, top),
            at(s, -0.92 * share, 0.4 * top + 0.6 * keel), at(s, -0.5 * share, keel), at(s, 0.5 * share, keel),
            at(s, 0.92 * share, 0.4 * top + 0.6 * keel)};
    };
    const auto tip = [&](const HullStation& s)
    { return std::vector<Corner>(7, at(s, 0.0, 0.5 * s.sheer * freeboardM)); };
    rows.push_back(tip(stations.front()));
    for (const HullStation& station : stations)
        rows.push_back(ring(station, 1.0));
    rows.push_back(tip(stations.back()));
    builder.begin("hull", kShipPaint, {shape.red, shape.green, shape.blue});
    builder.grid(rows);
}

/// A block of decks with a band of windows below each roof.
void addDecks(ModelBuilder& builder, const glm::dvec3& low, const glm::dvec3& high, int decks)
{
    const double deckM = (high.z - low.z) / decks;
    for (int i = 0; i < decks; ++i)
    {
        const double inset = 0.04 * i * (high.x - low.x);
        const glm::dvec3 from(low.x + 0.5 * inset, low.y + 0.3 * inset, low.z + i * deckM),
            to(high.x - inset, high.y - 0.3 * inset, low.z + (i + 1) * deckM);
        builder.begin("decks", kShipPaint, kWhiteShip);
        box(builder, from, to);
        builder.begin("deck windows", kShipPaint, kGlassOfShip);
        const double proud = 0.004 * (high.x - low.x) + 0.01;
        box(builder, {from.x + 0.06 * (to.x - from.x), from.y - proud, from.z + 0.50 * deckM},
            {to.x + proud, to.y + proud, from.z + 0.78 * deckM});
    }
}

void addCargoShip(ModelBuilder& builder, const EntityShape& shape, double deckM)
{
    const double l = shape.lengthM, half = 0.5 * shape.widthM;
    addDecks(builder, {-0.44 * l, -0.85 * half, deckM}, {-0.33 * l, 0.85 * half, 0.86 * shape.heightM}, 4);
    builder.begin("funnel", kShipPaint, {shape.red, shape.green, shape.blue});
    addHull(builder,
            {{-0.47 * l, 0.22 * half, deckM, 0.80 * shape.heightM},
             {-0.445 * l, 0.22 * half, deckM, 0.84 * shape.heightM}},
            4.0);
    builder.begin("mast", kPlain, kWhiteShip);
    bar(builder, {-0.36 * l, 0.0, 0.84 * shape.heightM}, {-0.36 * l, 0.0, shape.heightM}, 0.002 * l);
    const std::array<glm::vec3, 4> paints{
        {{0.55F, 0.20F, 0.13F}, {0.16F, 0.28F, 0.42F}, {0.30F, 0.40F, 0.28F}, {0.62F, 0.55F, 0.40F}}};
    for (int row = 0; row < 6; ++row) // stacks of containers
        for (int stack = 0; stack < 4; ++stack)
        {
            const auto pick = static_cast<std::size_t>(row * 7 + stack * 3);
            const double x = (-0.29 + 0.112 * row) * l, y = (-0.84 + 0.425 * stack) * half;
            builder.begin("containers", kPlain, paints[pick % paints.size()]);
            box(builder, {x, y, deckM},
                {x + 0.102 * l, y + 0.40 * half,
                 deckM + (0.16 + 0.06 * static_cast<double>(pick % 3)) * shape.heightM});
        }
}

void addMotorBoat(ModelBuilder& builder, const EntityShape& shape, double deckM)
{
    const double l = shape.lengthM, half = 0.5 * shape.widthM;
    addDecks(builder, {-0.22 * l, -0.62 * half, deckM}, {0.14 * l, 0.62 * half, 0.82 * shape.heightM}, 1);
    builder.begin("cockpit", kPlain, kDeck);
    box(builder, {-0.45 * l, -0.65 * half, deckM - 0.02},
        {-0.23 * l, 0.65 * half, deckM + 0.04 * shape.heightM});
    builder.begin("mast", kPlain, kWhiteShip);
    bar(builder, {-0.05 * l, 0.0, 0.82 * shape.heightM}, {-0.08 * l, 0.0, shape.heightM}, 0.006 * l);
}

} // namespace

EntityModel makeShip(const EntityShape& shape)
{
    const bool isShip = shape.lengthM >= kSmallestShipM;
    const double freeboard = (isShip ? 0.30 : 0.42) * shape.heightM,
                 draught = std::min(0.25 * shape.widthM, freeboard);
    ModelBuilder builder;
    addShipHull(builder, shape, freeboard, draught);
    if (isShip)
        addCargoShip(builder, shape, freeboard);
    else
        addMotorBoat(builder, shape, freeboard);
    EntityModel model;
    model.parts = {model.addMesh(builder.finish())};
    const glm::dmat4 placed = glm::translate(glm::dmat4(1.0), {shape.middleXM, 0.0, 0.0});
    model.pose = [placed](const EntityMotion&) { return std::vector<glm::dmat4>{placed}; };
    model.eye = {shape.middleXM + (isShip ? -0.33 : 0.0) * shape.lengthM, 0.0, 0.82 * shape.heightM};
    return model;
}

} // namespace scenery::models
