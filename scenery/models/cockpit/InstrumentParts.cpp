// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/cockpit/InstrumentParts.h"

#include <cmath>
#include <numbers>

#include <foundation/Angle.h>
#include <glm/gtc/matrix_transform.hpp>

#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

constexpr int kRoundSides = 32;
const glm::vec3 kNeedle(1.0F, 0.98F, 0.92F), kBezel(0.10F, 0.10F, 0.11F);

glm::dvec2 rimPoint(double turnRad)
{
    return {std::sin(turnRad), std::cos(turnRad)};
}

glm::dmat4 clockwise(double angleDeg)
{
    return glm::rotate(glm::dmat4(1.0), -foundation::radiansOf(angleDeg), {0.0, 0.0, 1.0});
}

Model faceModel(Instrument instrument, double radiusM)
{
    const InstrumentCell cell = cellOf(instrument);
    ModelBuilder builder;
    builder.begin("face", kInstrumentSurface);
    const auto corner = [&](const glm::dvec2& at) {
        return Corner{{radiusM * at, kFaceLiftM}, cell.uvAt(at), {0.0F, 0.0F, 1.0F}};
    };
    for (int i = 0; i < kRoundSides; ++i)
    {
        const auto rim = [&](int k) { return corner(rimPoint(-2.0 * std::numbers::pi * k / kRoundSides)); };
        builder.triangle(corner({0.0, 0.0}), rim(i), rim(i + 1));
    }
    return builder.finish();
}

/// A flat shape of the plain colour that looks at the eye. `corners`: counter-clockwise, convex about the
/// first.
Model flatModel(const std::vector<glm::dvec2>& corners, const glm::vec3& tint)
{
    ModelBuilder builder;
    builder.begin("hand", kPlain, tint);
    const auto corner = [&](std::size_t i) {
        return Corner{{corners[i], 0.0}, plainUv(), {0.0F, 0.0F, 1.0F}};
    };
    for (std::size_t i = 2; i < corners.size(); ++i)
        builder.triangle(corner(0), corner(i - 1), corner(i));
    return builder.finish();
}

Model needleModel(const DialHand& hand, double radiusM)
{
    const double tip = hand.reach * radiusM, half = 0.5 * hand.width * radiusM;
    return flatModel(
        {{0.0, tip}, {-half, 0.72 * tip}, {-half, -0.2 * tip}, {half, -0.2 * tip}, {half, 0.72 * tip}},
        kNeedle);
}

Model aeroplaneModel(const DialHand& hand, double radiusM)
{
    const double wing = hand.reach * radiusM, half = 0.035 * radiusM;
    ModelBuilder builder;
    builder.begin("aeroplane", kPlain, kNeedle);
    const auto rectangle = [&](const glm::dvec2& low, const glm::dvec2& high)
    {
        const auto at = [](double x, double y) { return Corner{{x, y, 0.0}, plainUv(), {0.0F, 0.0F, 1.0F}}; };
        builder.quad(at(low.x, low.y), at(high.x, low.y), at(high.x, high.y), at(low.x, high.y));
    };
    rectangle({-wing, -half}, {wing, half});
    rectangle({-2.5 * half, -2.5 * half}, {2.5 * half, -half});
    rectangle({-2.5 * half, half}, {2.5 * half, 2.5 * half});
    rectangle({-half, 2.5 * half}, {half, 8.0 * half});
    return builder.finish();
}

Model slipBallModel(const DialHand& hand, double radiusM)
{
    std::vector<glm::dvec2> rim;
    for (int i = 0; i < 16; ++i)
        rim.push_back(0.5 * hand.width * radiusM * rimPoint(-2.0 * std::numbers::pi * i / 16.0) -
                      glm::dvec2(0.0, hand.reach * radiusM));
    return flatModel(rim, {0.06F, 0.06F, 0.06F});
}

Model handModel(const PlacedInstrument& placed, const DialHand& hand)
{
    switch (hand.shape)
    {
    case DialHand::Shape::card:
        return faceModel(placed.instrument, placed.radiusM);
    case DialHand::Shape::aeroplane:
        return aeroplaneModel(hand, placed.radiusM);
    case DialHand::Shape::ball:
        return slipBallModel(hand, placed.radiusM);
    default:
        return needleModel(hand, placed.radiusM);
    }
}

/// A ring around a face, standing out from the panel.
Model bezelModel(double radiusM)
{
    ModelBuilder builder;
    builder.begin("bezel", kPlain, kBezel);
    std::vector<std::vector<Corner>> rows;
    for (const auto& [share, liftM] :
         {std::pair{1.14, 0.0}, {1.12, 0.006}, {1.02, 0.006}, {0.99, kFaceLiftM}})
    {
        std::vector<Corner>& row = rows.emplace_back();
        for (int i = 0; i <= kRoundSides; ++i)
            row.push_back(
                {{share * radiusM * rimPoint(-2.0 * std::numbers::pi * (i % kRoundSides) / kRoundSides),
                  liftM},
                 plainUv()});
    }
    builder.grid(rows);
    return builder.finish(30.0);
}

void addDial(InteriorModel& interior, const PlacedInstrument& placed, const glm::dmat4& entityFromDial)
{
    const Dial& dial = dialOf(placed.instrument);
    const std::string name(dial.label);
    const auto fixed = [=](const Readings&) { return entityFromDial; };
    if (dial.hands.front().shape != DialHand::Shape::card)
        interior.parts.push_back(
            {name + " face", faceModel(placed.instrument, placed.radiusM), InteriorCoat::dial, fixed});
    for (std::size_t i = 0; i < dial.hands.size(); ++i)
    {
        const DialHand& hand = dial.hands[i];
        const bool isCard = hand.shape == DialHand::Shape::card;
        const double liftM =
            isCard ? 0.0 : kHandLiftM + kHandStepM * static_cast<double>(dial.hands.size() - i);
        const glm::dmat4 lifted = glm::translate(entityFromDial, {0.0, 0.0, liftM});
        interior.parts.push_back(
            {name + " hand", handModel(placed, hand), InteriorCoat::dial, [=](const Readings& readings) {
                 return lifted * clockwise(handAngleDeg(hand, readings[hand.reading]));
             }});
    }
    if (dial.hands.front().shape == DialHand::Shape::card) // the lubber line
        interior.parts.push_back({name + " line",
                                  flatModel({{-0.03 * placed.radiusM, 1.0 * placed.radiusM},
                                             {0.0, 0.80 * placed.radiusM},
                                             {0.03 * placed.radiusM, 1.0 * placed.radiusM}},
                                            {1.0F, 0.55F, 0.1F}),
                                  InteriorCoat::dial, [=](const Readings&) {
                                      return glm::translate(entityFromDial, {0.0, 0.0, kHandLiftM});
                                  }});
    interior.parts.push_back({name + " bezel", bezelModel(placed.radiusM), InteriorCoat::inside, fixed});
}

} // namespace

glm::dvec3 needleTip(const DialHand& hand, double radiusM, double value)
{
    return {hand.reach * radiusM * rimPoint(foundation::radiansOf(handAngleDeg(hand, value))), kHandLiftM};
}

void addInstruments(InteriorModel& interior, std::span<const PlacedInstrument> panel,
                    const glm::dmat4& entityFromPanel)
{
    for (const PlacedInstrument& placed : panel)
    {
        const glm::dmat4 entityFromDial = glm::translate(entityFromPanel, glm::dvec3(placed.middle, 0.0));
        if (placed.instrument == Instrument::attitude)
            addAttitude(interior, placed, entityFromDial);
        else
            addDial(interior, placed, entityFromDial);
    }
}

} // namespace scenery::models
