// SPDX-License-Identifier: Apache-2.0
// The cockpit of a small high-wing aeroplane from its left seat. Other aircraft have its panel and the frames
// of its windows alone.
#include <cmath>

#include <foundation/Angle.h>
#include <glm/gtc/matrix_transform.hpp>

#include "scenery/models/cockpit/InstrumentParts.h"
#include "scenery/models/cockpit/InteriorShell.h"
#include "scenery/models/entities/LightAircraftForm.h"

namespace scenery::models
{

namespace
{

// From the eye. Units: metres.
constexpr double kPanelXM = 0.64, kPanelTopM = -0.105, kPanelLowM = -0.56, kLeftM = 0.26, kRightM = -0.80,
                 kCockpitRoofM = 0.27;

Model panelModel()
{
    ModelBuilder builder;
    builder.begin("panel", kPlain, kPanelGrey);
    box(builder, {kPanelXM, kRightM, kPanelLowM}, {kPanelXM + 0.03, kLeftM, kPanelTopM});
    builder.begin("glareshield", kPlain, kSeam);
    box(builder, {kPanelXM - 0.07, kRightM, kPanelTopM}, {kPanelXM + 0.30, kLeftM, kPanelTopM + 0.018});
    return builder.finish(30.0);
}

/// Pillars, roof, doors below their windows.
Model cockpitCabinModel()
{
    ModelBuilder builder;
    builder.begin("cabin", kPlain, kLining);
    for (const double side : {kLeftM + 0.01, kRightM - 0.01})
    {
        addPost(builder, {kPanelXM + 0.28, side, kPanelTopM}, {0.30, side, kCockpitRoofM}, 0.022);
        addPost(builder, {-0.45, side, -0.30}, {-0.45, side, kCockpitRoofM}, 0.035);
        box(builder, {-1.3, side - 0.02, -0.95}, {kPanelXM + 0.28, side + 0.02, -0.26});
        box(builder, {-1.3, side - 0.025, kCockpitRoofM - 0.03}, {0.32, side + 0.025, kCockpitRoofM + 0.02});
    }
    box(builder, {-1.3, kRightM, kCockpitRoofM}, {0.32, kLeftM, kCockpitRoofM + 0.03});
    const double middle = 0.5 * (kLeftM + kRightM);
    addPost(builder, {kPanelXM + 0.28, middle, kPanelTopM + 0.01}, {0.32, middle, kCockpitRoofM}, 0.008);
    return builder.finish(30.0);
}

/// What the eye sees of the aeroplane outside, in its own frame.
Model outsideModel(const glm::vec3& trim)
{
    ModelBuilder builder;
    builder.begin("cowling", kAircraftPaint, kAircraftWhite);
    addLoft(builder,
            fuselageRings({kLightSections.begin() + kLightCowling, kLightSections.end()}, kLightRoundness),
            32);
    builder.begin("wings", kAircraftPaint, kAircraftWhite);
    const std::vector<AerofoilStation> left(kLightWing.begin() + 1, kLightWing.end());
    addWingPanel(builder, {left});
    addWingPanel(builder, {mirrored(left)});
    builder.begin("struts", kAircraftPaint, kAircraftWhite);
    for (const double side : {1.0, -1.0})
    {
        const glm::dvec3 across(1.0, side, 1.0);
        bar(builder, across * kLightStrutLow, across * kLightStrutHigh, kLightStrutRadiusM);
    }
    builder.begin("spinner", kAircraftPaint, trim);
    addLimb(builder, kLightPropellerHub - glm::dvec3(0.08, 0.0, 0.0),
            kLightPropellerHub + glm::dvec3(0.08, 0.0, 0.0), 0.17, 0.12);
    return builder.finish();
}

void addOutside(InteriorModel& interior, const EntityShape& shape)
{
    constexpr double kBlurRadps = 20.0; // as RotorDisc.h has it
    const double scale = shape.lengthM / kLightLengthM;
    const glm::dmat4 sized = glm::scale(glm::dmat4(1.0), glm::dvec3(scale));
    interior.parts.push_back({"outside", outsideModel({shape.red, shape.green, shape.blue}),
                              InteriorCoat::outside, [=](const Readings&) { return sized; }});
    EntityRotor rotor{.hub = kLightPropellerHub, .axis = {1.0, 0.0, 0.0}, .radiusM = kLightPropellerRadiusM};
    ModelBuilder blades;
    blades.begin("blades", kAircraftPaint, kAircraftTyre);
    addBlades(blades, rotor, 2, kLightPropellerChordM);
    interior.parts.push_back(
        {"blades", blades.finish(), InteriorCoat::outside,
         [=](const Readings& readings)
         {
             return glm::translate(glm::rotate(glm::translate(sized, kLightPropellerHub),
                                               foundation::radiansOf(readings[Reading::propellerTurnDeg]),
                                               {1.0, 0.0, 0.0}),
                                   -kLightPropellerHub);
         },
         [](const Readings& readings) { return !(readings[Reading::propellerRadps] > kBlurRadps); }});
    rotor.hub *= scale;
    rotor.radiusM *= scale;
    rotor.hubRadiusM *= scale;
    interior.propeller = rotor;
}

} // namespace

InteriorModel makeAircraftCockpit(const EntityShape& shape, const glm::dvec3& eye)
{
    InteriorModel interior;
    interior.lookDownDeg = 7.0;
    interior.panel = panelViewOf(aircraftPanel(), kPanelXM);
    const auto atEye = movedBy(eye);
    interior.parts.push_back({"panel", panelModel(), InteriorCoat::inside, atEye});
    interior.parts.push_back({"cabin", cockpitCabinModel(), InteriorCoat::inside, atEye});
    const glm::dmat4 panel = upright(eye + glm::dvec3(kPanelXM, 0.0, 0.0));
    addInstruments(interior, aircraftPanel(), panel);
    addDrums(interior,
             {"altimeter setting",
              {0.095, -0.2305, 0.0},
              0.009,
              4,
              DrumColumn::digits,
              [](const Readings& readings)
              { return static_cast<int>(std::lround(readings[Reading::altimeterHpa])); }},
             panel);
    if (shape.kind == EntityKind::lightAircraft) addOutside(interior, shape);
    return interior;
}

} // namespace scenery::models
