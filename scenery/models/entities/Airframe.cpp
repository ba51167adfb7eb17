// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/Airframe.h"

#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "scenery/models/mesh/MeasureModel.h"

namespace scenery::models
{

namespace
{

glm::dmat4 turnedAbout(const glm::dvec3& pivot, const glm::dvec3& axis, double angleRad)
{
    const glm::dmat4 there = glm::translate(glm::dmat4(1.0), pivot);
    return glm::translate(glm::rotate(there, angleRad, axis), -pivot);
}

std::string nameOf(const AircraftPart& part)
{
    static constexpr std::array kNames{"body",      "elevator",   "left aileron", "right aileron", "rudder",
                                       "left flap", "right flap", "rotor",        "leg",           "wheel"};
    const std::string name = kNames[static_cast<std::size_t>(part.joint)];
    const bool isOfLeg = part.joint == AircraftJoint::leg || part.joint == AircraftJoint::wheel;
    return isOfLeg ? name + ' ' + std::to_string(part.index) : name;
}

/// Poses the parts of an aircraft.
struct AircraftPose
{
    std::vector<AircraftPart> parts;

    std::vector<glm::dmat4> operator()(const EntityMotion& motion) const
    {
        std::vector<glm::dmat4> pose;
        for (const AircraftPart& part : parts)
            pose.push_back(matrixOf(part, motion));
        return pose;
    }

    /// A trailing edge that goes down turns against the axis to the left, one that goes left against the axis
    /// upwards.
    static double angleOf(AircraftJoint joint, const AircraftMotion& motion)
    {
        switch (joint)
        {
        case AircraftJoint::elevator:
            return -motion.elevatorRad;
        case AircraftJoint::leftAileron:
            return -motion.leftAileronRad;
        case AircraftJoint::rightAileron:
            return -motion.rightAileronRad;
        case AircraftJoint::rudder:
            return -motion.rudderRad;
        case AircraftJoint::leftFlap:
        case AircraftJoint::rightFlap:
            return -motion.flapRad;
        case AircraftJoint::rotor:
            return motion.rotorTurnRad;
        default:
            return 0.0;
        }
    }

    static glm::dmat4 legMatrix(const AircraftPart& part, const AircraftMotion& motion)
    {
        glm::dvec3 moved(0.0);
        if (motion.legs)
        {
            const AircraftMotion::Leg& leg = (*motion.legs)[part.index];
            moved = leg.bottom + glm::dvec3(0.0, 0.0, leg.strutM) - part.bottom;
        }
        const glm::dmat4 placed = glm::translate(glm::dmat4(1.0), moved);
        if (part.index != 0) return placed; // the nose leg alone steers
        return placed * turnedAbout(part.bottom, {0.0, 0.0, 1.0}, motion.noseSteeringRad);
    }

    static glm::dmat4 matrixOf(const AircraftPart& part, const EntityMotion& motion)
    {
        const AircraftMotion& aircraft = motion.aircraft;
        if (part.joint == AircraftJoint::leg) return legMatrix(part, aircraft);
        if (part.joint != AircraftJoint::wheel)
            return turnedAbout(part.pivot, part.axis, part.turns * angleOf(part.joint, aircraft));
        const double rolled = aircraft.legs
                                  ? (*aircraft.legs)[part.index].turnRad
                                  : std::fmod(motion.odometerM / part.wheelRadiusM, 2.0 * std::numbers::pi);
        return legMatrix(part, aircraft) * turnedAbout(part.pivot, {0.0, 1.0, 0.0}, rolled);
    }
};

glm::dvec3 loftPoint(const LoftRing& ring, int point, int sides)
{
    const double turn = 2.0 * std::numbers::pi * (point % sides) / sides;
    const auto rounded = [&](double c) { return std::copysign(std::pow(std::abs(c), 2.0 / ring.power), c); };
    return ring.middle + ring.halfA * rounded(std::cos(turn)) + ring.halfB * rounded(std::sin(turn));
}

/// Makes a mesh larger about the entity's origin.
void resizeMesh(Model& model, double scale)
{
    for (glm::dvec3& p : model.mesh.positions)
        p *= scale;
    measureModel(model);
}

} // namespace

std::size_t Airframe::add(const AircraftPart& part, ModelBuilder& builder)
{
    _model.parts.push_back(_model.addMesh(builder.finish()));
    _parts.push_back(part);
    return _parts.size(); // the body will be the first
}

void Airframe::addSurface(AircraftJoint joint, const std::vector<AerofoilStation>& stations,
                          double hingeShare, const glm::vec3& tint)
{
    constexpr double kGapM = 0.012;
    const glm::dvec3 from = chordPoint(stations.front(), hingeShare),
                     to = chordPoint(stations.back(), hingeShare);
    glm::dvec3 axis = glm::normalize(to - from);
    if (joint != AircraftJoint::rudder && axis.y < 0.0) axis = -axis;
    std::vector<AerofoilStation> within = stations; // a gap to the wing on either end
    const double share = kGapM / glm::length(to - from);
    within.front().leadingEdge += (stations.back().leadingEdge - stations.front().leadingEdge) * share;
    within.back().leadingEdge += (stations.front().leadingEdge - stations.back().leadingEdge) * share;
    ModelBuilder builder;
    builder.begin("surface", kAircraftPaint, tint);
    addWingPanel(builder, {within, hingeShare + kGapM / stations.front().chordM, 1.0});
    AircraftPart part;
    part.joint = joint;
    part.pivot = from;
    part.axis = axis;
    add(part, builder);
}

void Airframe::addFlappedWings(const std::array<AerofoilStation, 4>& stations,
                               const std::array<AerofoilStation, 2>& tip, const glm::vec3& trim)
{
    const auto& [root, inner, middle, outer] = stations;
    Wing flapped;
    flapped.stations = {root, inner, middle};
    flapped.hingedFrom = 1;
    flapped.hingedTo = 2;
    flapped.left = AircraftJoint::leftFlap;
    flapped.right = AircraftJoint::rightFlap;
    addWings(flapped);
    Wing banking;
    banking.stations = {middle, outer};
    banking.left = AircraftJoint::leftAileron;
    banking.right = AircraftJoint::rightAileron;
    addWings(banking);
    const std::vector<AerofoilStation> tips{outer, tip[0], tip[1]};
    _body.begin("tips", kAircraftPaint, trim);
    addWingPanel(_body, {tips});
    addWingPanel(_body, {mirrored(tips)});
}

void Airframe::addWing(const Wing& wing, AircraftJoint joint)
{
    const auto& all = wing.stations;
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(wing.hingedFrom),
               last = all.begin() + static_cast<std::ptrdiff_t>(wing.hingedTo);
    _body.begin("wing", kAircraftPaint, wing.tint);
    if (first != all.begin()) addWingPanel(_body, {{all.begin(), first + 1}});
    if (joint == AircraftJoint::fixed)
        addWingPanel(_body, {{first, last + 1}});
    else
        addWingPanel(_body, {{first, last + 1}, 0.0, wing.hingeShare});
    if (last + 1 != all.end()) addWingPanel(_body, {{last, all.end()}});
    if (joint != AircraftJoint::fixed) addSurface(joint, {first, last + 1}, wing.hingeShare, wing.tint);
}

void Airframe::addWings(const Wing& wing)
{
    addWing(wing, wing.left);
    Wing right = wing;
    right.stations = mirrored(wing.stations);
    addWing(right, wing.right);
}

void Airframe::addLeg(std::size_t index, const glm::dvec3& from, const glm::dvec3& bottom, double radiusM,
                      double wideM)
{
    const glm::dvec3 hub = bottom + glm::dvec3(0.0, 0.0, radiusM);
    AircraftPart part{
        .joint = AircraftJoint::leg, .pivot = hub, .index = index, .bottom = bottom, .wheelRadiusM = radiusM};
    ModelBuilder leg;
    leg.begin("leg", kPlain, kAircraftMetal);
    bar(leg, from, hub, 0.16 * radiusM);
    bar(leg, hub - glm::dvec3(0.0, 0.6 * wideM, 0.0), hub + glm::dvec3(0.0, 0.6 * wideM, 0.0),
        0.12 * radiusM);
    add(part, leg);
    ModelBuilder wheel;
    const auto ring = [&](double y, double share)
    {
        return LoftRing{hub + glm::dvec3(0.0, y * wideM, 0.0), glm::dvec3(0.0, 0.0, share * radiusM),
                        glm::dvec3(share * radiusM, 0.0, 0.0)};
    };
    wheel.begin("tyre", kPlain, kAircraftTyre);
    addLoft(wheel,
            {ring(-0.3, 0.0), ring(-0.3, 0.5), ring(-0.5, 0.78), ring(-0.36, 1.0), ring(0.36, 1.0),
             ring(0.5, 0.78), ring(0.3, 0.5), ring(0.3, 0.0)},
            24);
    wheel.begin("rim", kPlain, kAircraftMetal);
    for (const double side : {1.0, -1.0}) // a bar across shows that it turns
        box(wheel, hub + glm::dvec3(-0.45 * radiusM, side * 0.31 * wideM - 0.01, -0.08 * radiusM),
            hub + glm::dvec3(0.45 * radiusM, side * 0.31 * wideM + 0.01, 0.08 * radiusM));
    part.joint = AircraftJoint::wheel;
    add(part, wheel);
}

void addBlades(ModelBuilder& builder, const EntityRotor& rotor, int blades, double chordM)
{
    const glm::dvec3 aside =
        std::abs(rotor.axis.z) > 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 a = glm::normalize(glm::cross(aside, rotor.axis)), b = glm::cross(rotor.axis, a);
    for (int i = 0; i < blades; ++i)
    {
        const double turn = 2.0 * std::numbers::pi * i / blades;
        const glm::dvec3 out = a * std::cos(turn) + b * std::sin(turn), across = glm::cross(rotor.axis, out);
        const auto ring = [&](double share, double wide, double twistRad)
        {
            const glm::dvec3 chord = across * std::cos(twistRad) + rotor.axis * std::sin(twistRad);
            return LoftRing{rotor.hub + out * (share * rotor.radiusM), chord * (0.5 * wide * chordM),
                            glm::cross(out, chord) * (0.06 * wide * chordM)};
        };
        addLoft(builder,
                {ring(0.04, 0.0, 0.0), ring(0.04, 0.5, 0.7), ring(0.35, 1.0, 0.45), ring(0.9, 0.8, 0.2),
                 ring(1.0, 0.35, 0.2), ring(1.0, 0.0, 0.2)},
                12);
    }
}

void Airframe::addRotor(const EntityRotor& rotor, int blades, double chordM, const glm::vec3& tint)
{
    ModelBuilder builder;
    builder.begin("blades", kAircraftPaint, tint);
    addBlades(builder, rotor, blades, chordM);
    EntityRotor made = rotor;
    made.blades =
        add({.joint = AircraftJoint::rotor, .pivot = rotor.hub, .axis = rotor.axis, .turns = rotor.turns},
            builder);
    _model.rotors.push_back(made);
}

void Airframe::addLamp(EntityLamp::Kind kind, const glm::dvec3& at, double asideRad, double halfAngleRad,
                       bool looksAhead)
{
    EntityLamp lamp{.kind = kind, .middle = at, .looksAhead = looksAhead, .widthM = 0.06, .heightM = 0.06};
    lamp.asideRad = asideRad;
    lamp.halfAngleRad = halfAngleRad;
    _model.lamps.push_back(lamp);
}

void Airframe::addNavigationLamps(const glm::dvec3& leftTip, const glm::dvec3& tail, const glm::dvec3& beacon)
{
    using Lamp = EntityLamp::Kind;
    const double half = std::numbers::pi * 55.0 / 180.0; // red and green: from straight ahead to 110° aside
    const glm::dvec3 rightTip = leftTip * glm::dvec3(1.0, -1.0, 1.0);
    addLamp(Lamp::navigationRed, leftTip, half, half);
    addLamp(Lamp::navigationGreen, rightTip, -half, half);
    addLamp(Lamp::navigationWhite, tail, 0.0, std::numbers::pi * 70.0 / 180.0, false);
    for (const glm::dvec3& at : {leftTip, rightTip, tail})
        addLamp(Lamp::strobe, at - glm::dvec3(0.08, 0.0, 0.0), 0.0, 4.0);
    addLamp(Lamp::beacon, beacon, 0.0, 4.0);
}

EntityModel Airframe::finish(double scale, const glm::dvec3& eye)
{
    constexpr double kAsBuilt = 0.1;
    if (std::abs(scale - 1.0) < kAsBuilt) scale = 1.0;
    _model.parts.insert(_model.parts.begin(), _model.addMesh(_body.finish()));
    _parts.insert(_parts.begin(), AircraftPart{});
    for (Model& mesh : _model.meshes)
        resizeMesh(mesh, scale);
    for (AircraftPart& part : _parts)
    {
        part.pivot *= scale;
        part.bottom *= scale;
        part.wheelRadiusM *= scale;
    }
    for (EntityLamp& lamp : _model.lamps)
        lamp.middle *= scale;
    for (EntityRotor& rotor : _model.rotors)
    {
        rotor.hub *= scale;
        rotor.radiusM *= scale;
        rotor.hubRadiusM *= scale;
    }
    for (const AircraftPart& part : _parts)
        _model.names.push_back(nameOf(part));
    _model.pose = AircraftPose{std::move(_parts)};
    _model.eye = scale * eye;
    return std::move(_model);
}

void addBand(ModelBuilder& builder, const std::vector<LoftRing>& rings, int sides, const LoftBand& band)
{
    std::vector<std::vector<Corner>> rows;
    for (std::size_t r = band.fromRing; r <= band.toRing; ++r)
    {
        std::vector<Corner>& row = rows.emplace_back();
        for (int i = band.fromPoint; i <= band.toPoint; ++i)
        {
            const glm::dvec3 at = loftPoint(rings[r], i, sides);
            row.push_back({at + glm::normalize(at - rings[r].middle) * band.liftM, plainUv()});
        }
    }
    builder.grid(rows);
}

std::vector<LoftRing> fuselageRings(const std::vector<FuselageSection>& sections, double power)
{
    const auto ring = [&](const FuselageSection& s, double share)
    {
        return LoftRing{
            {s.x, 0.0, s.z}, {0.0, share * s.halfWidth, 0.0}, {0.0, 0.0, share * s.halfHeight}, power};
    };
    std::vector<LoftRing> rings{ring(sections.front(), 0.0)};
    for (const FuselageSection& section : sections)
        rings.push_back(ring(section, 1.0));
    rings.push_back(ring(sections.back(), 0.0));
    return rings;
}

} // namespace scenery::models
