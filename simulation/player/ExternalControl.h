// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "simulation/player/Actor.h"
#include "simulation/player/MotionSource.h"
#include "simulation/state/EntityTold.h"

namespace simulation
{

/// The entities that vehicles with physics move in place of the actions: attached for the whole play, by a
/// controller while it is active, or by a person while the person has it, who comes before a controller: that
/// one begins anew when the entity is given back. A vehicle has one body, so it moves its entity while either
/// domain is its own; in the other domain it does what the scenario asks.
class ExternalControl
{
public:
    /// Which domains a controller is given or loses; nothing: as before.
    struct Wish
    {
        std::optional<bool> longitudinal{}, lateral{};
    };

    /// Whom it works on; it must outlive this.
    struct Place
    {
        const Scenario& scenario;
        std::vector<Actor>& actors; ///< of the scenario's entities, in their order
        std::function<EnvironmentState()> environment;
        std::function<WayAhead(const EntityMotion&)> wayOf;
    };

    /// `source` may be null: then controllers of that kind leave the entity to the scenario.
    ExternalControl(Place place, std::shared_ptr<MotionSource> source);

    /// Lets something move an entity for the whole play, from beginAll() on.
    void attach(std::size_t entity, std::shared_ptr<ExternalMotion> motion);

    /// Lets a person sit in an entity, from beginAll() on.
    void seat(std::size_t entity, std::shared_ptr<Seat> seat);

    /// What a manual controller of the storyboard asks. False: nobody can sit there.
    bool askSeat(std::size_t entity, bool isTaken);

    /// Whether turn() will let the person take the entity.
    bool isAboutToSit(std::size_t entity, double timeS) const;

    /// Lets persons take over and give back as their seats want, before the step that follows `timeS`.
    /// Returns whose entities have changed hands. What was given back, and is not moved by a controller then,
    /// is left to the caller, at the speed of Actor::askedMps.
    std::vector<std::size_t> turn(double timeS);

    /// The entity is no longer there: nobody moves it.
    void vanish(std::size_t entity, double timeS);

    /// Which entities those of a person touched in the last step: pairs of indices.
    std::vector<std::pair<int, int>> touches() const;

    /// What tables tell of each entity; empty: nobody may sit anywhere.
    const std::vector<EntityTold>& told() const { return _told; }

    /// Adds a line to notes().
    void note(std::string line) { _notes.push_back(std::move(line)); }

    /// Gives domains of an entity to a controller, or takes them back; before beginAll() from then on.
    void wish(std::size_t entity, const Controller& controller, const Wish& wish, double timeS);

    /// Gives the entity back to the scenario, which goes on at its speed. Does nothing where nothing has it.
    void release(std::size_t entity, double timeS);

    /// Begins anew where the entity now is: after a teleport.
    void restart(std::size_t entity, double timeS);

    /// After Init. Errors: one cannot begin.
    foundation::Outcome beginAll();

    /// Tells who has each entity, and what was hit since the step before; after all have moved.
    void tell();

    /// Whether some are attached for the whole play, and all of them are done; or the inputs of a person have
    /// ended.
    bool areDone(double timeS) const;

    /// What a person should know: controllers that could not begin, crashes. A line each.
    std::vector<std::string> notes() const;

private:
    Actor& at(std::size_t entity) { return _place.actors[entity]; }
    const Actor& at(std::size_t entity) const { return _place.actors[entity]; }
    foundation::Outcome sitDown(std::size_t entity, double timeS);
    void standUp(std::size_t entity, double timeS);
    void wishBehindPerson(std::size_t entity, const Controller& controller, const Wish& wish);
    std::string nameAt(std::size_t entity, double timeS) const;
    foundation::Outcome begin(std::size_t entity, Attachment attachment, double timeS);

    Place _place;
    std::shared_ptr<MotionSource> _source;
    bool _hasBegun = false;
    std::vector<std::string> _notes;
    std::vector<EntityTold> _told;
};

} // namespace simulation
