// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "simulation/vehicle/Ground.h"
#include "simulation/vehicle/flight/AircraftData.h"
#include "simulation/vehicle/flight/RigidBody.h"

namespace simulation
{

/// The feet of the pilot.
struct GroundControls
{
    double steering = 0.0; ///< -1…1, positive to the right
    double leftBrake = 0.0, rightBrake = 0.0;
    bool isBroken = false; ///< nothing rolls any more
};

/// A point of an aircraft that may touch the ground, during a step.
struct Contact
{
    glm::dvec3 arm{0.0};            ///< from the centre of mass, body axes
    GroundPoint ground;             ///< below it; of water, its bed
    std::optional<double> waterM{}; ///< z of the surface of water over that
    glm::dvec2 slip{0.0};           ///< how far the tyre is bent: along and across the wheel; metres
    double depthM = 0.0;            ///< how far the strut is pressed in
    double loadN = 0.0;             ///< across the ground
    double closingMps = 0.0;        ///< speed against the ground, at contact
    bool isGone = false;            ///< it touches nothing any more
};

/// Springs, dampers and tyres of all points of contact.
///
/// A tyre holds by a bent bristle: it bends with the sliding speed until its force is what friction allows;
/// so an aircraft that stands does not creep. A wheel that rolls takes the bend sideways out of its contact,
/// so its force is that of the slip angle, up to friction. Source: Dahl, *A Solid Friction Model*, 1968, in
/// the form of a spring with a limit; Currey, *Aircraft Landing Gear Design*, 1988, chapter 5 (struts);
/// Pacejka, *Tire and Vehicle Dynamics*, 2nd edition, 2006, section 5.2 (the stretched string: relaxation
/// length, slip angle).
class GroundContacts
{
public:
    /// `aircraft` must outlive this.
    explicit GroundContacts(const AircraftData& aircraft);

    /// Asks for the ground below all points; call once a step. Returns whether any point is near it.
    bool look(const BodyMotion& motion, const glm::dvec3& centre, const Ground& ground);

    /// Forces at the points, and the bend of the tyres after `stepS`. Body axes.
    ForceMoment press(const BodyMotion& motion, const glm::dvec3& earthRate, const GroundControls& controls,
                      double stepS);

    std::span<const Contact> contacts() const { return _contacts; }

    /// A part that broke off, or that the hull of a wreck stands for: it touches nothing any more.
    void drop(std::size_t index) { _contacts[index].isGone = true; }
    /// All parts are there again.
    void mend();

    /// How far the deepest point lies below the ground, and the ground there.
    double deepestM(const BodyMotion& motion, glm::dvec3& normal) const;

private:
    ForceMoment pressOne(std::size_t index, const BodyMotion& motion, const glm::dvec3& rates,
                         const GroundControls& controls, double stepS);

    const AircraftData& _aircraft;
    std::vector<Contact> _contacts;
    std::vector<glm::dvec3> _points;
    std::vector<GroundPoint> _answers;
};

} // namespace simulation
