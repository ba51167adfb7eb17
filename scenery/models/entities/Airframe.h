// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "scenery/models/entities/EntityModel.h"
#include "scenery/models/entities/Loft.h"
#include "scenery/models/entities/WingPanel.h"
#include "scenery/models/roads/RoadModelParts.h"

/// What the generators of aircraft share.
namespace scenery::models
{

inline constexpr glm::vec3 kAircraftWhite(0.93F, 0.93F, 0.91F), kCanopy(0.10F, 0.13F, 0.16F),
    kAircraftMetal(0.62F, 0.63F, 0.66F), kAircraftTyre(0.14F, 0.14F, 0.15F);
inline const Surface kAircraftPaint{Painting::plain, Coat::lacquered};

/// What moves a part.
enum class AircraftJoint
{
    fixed,
    elevator,
    leftAileron,
    rightAileron,
    rudder,
    leftFlap,
    rightFlap,
    rotor,
    leg,  ///< its `index` is that of AircraftMotion::legs
    wheel ///< of that leg
};

/// A part that turns about an axis through a pivot, in the entity's frame.
struct AircraftPart
{
    AircraftJoint joint = AircraftJoint::fixed;
    glm::dvec3 pivot{0.0}, axis{0.0, 1.0, 0.0};
    double turns = 1.0;     ///< of a rotor, while the first one turns once
    std::size_t index = 0;  ///< of a leg
    glm::dvec3 bottom{0.0}; ///< of a leg's wheel, where the model has it
    double wheelRadiusM = 0.2;
};

/// Builds an aircraft: a body and parts that move. Frame: x forward, y left, z up, the ground is z = 0.
/// Invariant: what finish() returns has as many matrices as parts.
class Airframe
{
public:
    ModelBuilder& body() { return _body; }

    /// Adds a part that was built in the entity's frame.
    std::size_t add(const AircraftPart& part, ModelBuilder& builder);

    /// Adds a hinged surface behind `hingeShare` of the chord, between two stations.
    void addSurface(AircraftJoint joint, const std::vector<AerofoilStation>& stations, double hingeShare,
                    const glm::vec3& tint);

    /// Adds a wing or a tailplane on both sides with a hinged surface on each: stations from the root to the
    /// tip on the left.
    /// `hinged`: indices of the first and last station of the surface.
    struct Wing
    {
        std::vector<AerofoilStation> stations;
        double hingeShare = 0.72;
        AircraftJoint left = AircraftJoint::elevator, right = AircraftJoint::elevator;
        std::size_t hingedFrom = 0, hingedTo = 1;
        glm::vec3 tint = kAircraftWhite;
    };
    void addWings(const Wing& wing);

    /// Adds the wings of a light aircraft: flaps from the second to the third station, ailerons from there to
    /// the fourth, and from there tips in the trim.
    void addFlappedWings(const std::array<AerofoilStation, 4>& stations,
                         const std::array<AerofoilStation, 2>& tip, const glm::vec3& trim);

    /// Adds one side of a wing or a fin: what is not hinged belongs to the body.
    void addWing(const Wing& wing, AircraftJoint joint);

    /// Adds a leg and its wheel. `from`: where it leaves the body.
    void addLeg(std::size_t index, const glm::dvec3& from, const glm::dvec3& bottom, double radiusM,
                double wideM);

    /// Adds blades about a hub, and what replaces them at speed.
    void addRotor(const EntityRotor& rotor, int blades, double chordM, const glm::vec3& tint);

    void addLamp(EntityLamp::Kind kind, const glm::dvec3& at, double asideRad, double halfAngleRad,
                 bool looksAhead = true);

    /// The lamps on the wing tips and at the tail that the rules of the air ask for, strobes beside them, and
    /// a beacon.
    void addNavigationLamps(const glm::dvec3& leftTip, const glm::dvec3& tail, const glm::dvec3& beacon);

    /// Returns the model, `scale` times as large as it was built; as it was built, up to a tenth of
    /// difference. `eye`: as it was built.
    EntityModel finish(double scale, const glm::dvec3& eye);

private:
    EntityModel _model;
    std::vector<AircraftPart> _parts;
    ModelBuilder _body;
};

/// Adds the blades of a rotor about its hub, where they are before they turn. Precondition: a part with the
/// texture roadSigns has begun.
void addBlades(ModelBuilder& builder, const EntityRotor& rotor, int blades, double chordM);

/// Adds a band over the rings of a loft, from one ring and one point to others, a little above it: a window,
/// a stripe. Points are counted as addLoft() places them. Precondition: a part has begun.
struct LoftBand
{
    std::size_t fromRing, toRing;
    int fromPoint, toPoint;
    double liftM = 0.008;
};
void addBand(ModelBuilder& builder, const std::vector<LoftRing>& rings, int sides, const LoftBand& band);

/// A body of rounded cross-sections from its tail to its nose.
struct FuselageSection
{
    double x, z, halfWidth, halfHeight;
};
std::vector<LoftRing> fuselageRings(const std::vector<FuselageSection>& sections, double power);

} // namespace scenery::models
