// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>

#include "scenery/models/Model.h"
#include "scenery/models/roads/SignAtlas.h"

namespace scenery::models
{

/// What stands beside a road, as plain numbers: equal ones share one model.
/// Frame: x along the road for the traffic that it is meant for, y left, z up; its face looks towards -x, in
/// front of the post at x = 0, so that signs for both directions share one place. z = 0 is the road; posts
/// reach kPostDepthM below it. Units: metres.
struct RoadModel
{
    enum class Kind
    {
        sign,
        board,           ///< a place name or directions: text on a plate
        trafficLight,    ///< red, amber, green
        pedestrianLight, ///< red, green
        pole,
        delineator,
        lampPost,
        cone,
        bollard,
        railPost,   ///< of a guard rail
        gantry,     ///< a beam over the road on two posts, widthM apart
        runwaySign, ///< before a runway: its designators, white on red, as `text`
        box,        ///< any object of no model of its own, by its size
    };
    enum class Shape
    {
        round,
        triangle,
        triangleDown,
        octagon,
        diamond,
        square,
    };

    /// Where the arrow of a traffic light points.
    enum class Arrow
    {
        none,
        left,
        right,
        ahead,
        leftAhead,
        rightAhead,
    };

    Kind kind = Kind::box;
    Shape shape = Shape::round;
    SignFace face = SignFace::plain;
    int number = 0; ///< of a speed limit
    double lengthM = 0.0, widthM = 0.0, heightM = 0.0;
    double raisedM = 0.0;    ///< lower edge of a plate or of lamps above the road
    double postDepthM = 0.0; ///< how deep the post reaches below z = 0; 0: it has no post
    /// a post stands so far to the right of the plate or lamps, which hang from its arm; negative: to the
    /// left
    double armM = 0.0;
    double pitchRad = 0.0,
           rollRad = 0.0; ///< of plate or lamps, about y, then about the turned x; posts stay upright
    bool isTwoSided = false;
    bool isWhite = false; ///< a board of white, not of yellow
    Arrow arrow = Arrow::none;
    /// of a sign before a runway, or of a board: capitals and digits of Latin-1, lines parted by '\n'
    std::string text;

    auto operator<=>(const RoadModel&) const = default;
};

constexpr double kPostDepthM = 0.8;

/// Makes the model. Pure. One surface: kPlain; the face of a runway's sign is kLitPlain. Sizes of 0 are those
/// of the kind:
/// traffic lights DIN 67527 and EN 12368 (lenses of 0.2 m), delineators of the German RPS/HLB (1.05 m), lamp
/// posts of 8 m, cones of 0.75 m, bollards of 0.9 m, posts of rails of 0.7 m (EN 1317 systems: C 120 × 80
/// mm), gantries with 6 m of clearance over 15 m, signs before runways with letters of
/// 0.4 m, 1.1 m above the ground (ICAO Annex 14, 8th edition, table 5-5 and appendix 4).
Model makeRoadModel(const RoadModel& model);

/// A lens of a traffic light. Frame: the model's.
struct Lens
{
    glm::dvec3 middle{0.0};
    double radiusM = 0.1;
    SignFace face = SignFace::lampRed;
};

/// Returns the lenses of a traffic light from the top; none for other models. Before it is pitched and
/// rolled.
std::vector<Lens> lensesOf(const RoadModel& model);

/// How plate or lamps are turned, then moved, by pitch and roll: about their middle, and so far forward that
/// they clear the post.
struct Tilt
{
    glm::dmat3 turn{1.0};
    glm::dvec3 shift{0.0};

    glm::dvec3 at(const glm::dvec3& point) const { return turn * point + shift; }
};
Tilt tiltOf(const RoadModel& model);

/// Returns the axes of something that is pitched about its y, then rolled about its x. Positive pitch lowers
/// x, positive roll raises y.
/// Source: ASAM OpenDRIVE 1.8, 8.2 (right-handed; heading, then pitch, then roll).
glm::dmat3 pitchAndRoll(double pitchRad, double rollRad);

} // namespace scenery::models
