// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "simulation/contact/Impact.h"
#include "simulation/contact/MovingObstacle.h"
#include "simulation/vehicle/flight/AircraftData.h"
#include "simulation/vehicle/flight/RigidBody.h"

namespace simulation
{

class Ground;
class ObstacleMap;
struct ObstacleTouch;

/// A structural place in the frame of a hull: axes forward, left, up, about the same datum.
inline glm::dvec3 hullPlace(const glm::dvec3& place)
{
    return {-place.x, -place.y, place.z};
}

/// Boxes of wing, body and tail from the geometry, the propeller and the skids of a file that has no hull.
HullData hullOfMeasures(const AircraftData& aircraft);

/// What a hull met in a short step.
struct HullContact
{
    bool touches = false;      ///< anything
    double closingMps = 0.0;   ///< the hardest: by how much the contact changed the speed
    double groundMps = 0.0;    ///< the same where the ground was the hardest, else 0
    std::string_view reason{}; ///< why an aircraft that hit it so is no more sound
    glm::dvec3 place{0.0};     ///< in the frame of the scene
    std::uint32_t thing = 0;   ///< the number by which touches of it are known
};

/// The hull of an aircraft: how it meets what stands and moves in a scene, the ground where it is a wreck,
/// and water. Contacts are solved by Bullet, as those of road vehicles: it takes the speed that forces have
/// made, and gives back the place and the speed that contacts leave. Without a contact the motion stays as it
/// is, to the last bit.
/// Determinism: as BodyWorld. Threads: one.
class AircraftHull
{
public:
    explicit AircraftHull(std::shared_ptr<const AircraftData> aircraft);
    ~AircraftHull();
    AircraftHull(AircraftHull&&) noexcept;
    AircraftHull& operator=(AircraftHull&&) noexcept;

    void meet(std::shared_ptr<const ObstacleMap> obstacles);
    void meetMovers(std::span<const MovingObstacle> movers);
    std::span<const int> touchedMovers() const;
    std::span<const Impact> impacts() const;

    /// Nothing was hit, nothing is filled with water.
    void forget();

    /// Before a step: what is near? Things that give change the speed of `motion`. `timeS`: at the step's
    /// end.
    void look(BodyMotion& motion, const MassProperties& mass, const glm::dvec3& earthRate, double timeS,
              double stepS);
    /// Whether something is near, so that short steps and resolve() are needed.
    bool isNear() const;
    bool hasMovers() const;

    /// The number of a thing that the propeller's disc reaches, of those of the last look.
    std::optional<std::uint32_t> inPropeller(const BodyMotion& motion, const MassProperties& mass) const;

    /// Lays the ground below a wreck, for the steps that follow.
    void layGround(const BodyMotion& motion, const MassProperties& mass, const Ground& ground);

    /// How far the deepest corner lies below the ground. Units: metres.
    double deepestM(const BodyMotion& motion, const MassProperties& mass, const Ground& ground) const;

    /// Solves the contacts of a short step that led from `before` to `motion`.
    HullContact resolve(const BodyMotion& before, BodyMotion& motion, const MassProperties& mass,
                        const glm::dvec3& earthRate, double timeS, double stepS);

    /// Lets water flow in over a step, by the share of the lowest box that is under its level.
    void fill(const BodyMotion& motion, const MassProperties& mass, double levelM, double stepS);

    /// The share of its volume that water has not filled.
    double airShare() const { return _airShare; }

    /// Buoyancy and drag of water up to a level, body axes. `gravity`: scene's axes.
    ForceMoment swim(const BodyMotion& motion, const MassProperties& mass, const BodySurroundings& around,
                     double levelM, double stepS) const;

    void note(const ObstacleTouch& touch);

private:
    struct Parts;

    std::shared_ptr<const AircraftData> _aircraft;
    std::unique_ptr<Parts> _parts; ///< of a world of bodies
    double _airShare = 1.0;
};

} // namespace simulation
