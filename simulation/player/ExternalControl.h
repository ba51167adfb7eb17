// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "simulation/player/MotionSource.h"
#include "simulation/player/actions/RunningAction.h"

namespace simulation
{

/// The entities that vehicles with physics move in place of the actions: attached for the whole play, or by a
/// controller while it is active. A vehicle has one body, so it moves its entity while either domain is its
/// own; in the other domain it does what the scenario asks.
class ExternalControl
{
public:
    /// Which domains a controller is given or loses; nothing: as before.
    struct Wish
    {
        std::optional<bool> longitudinal{}, lateral{};
    };

    /// What the entities do by themselves; it must outlive this.
    struct Place
    {
        const Scenario& scenario;
        std::vector<EntityMotion>& motions;
        std::function<EnvironmentState()> environment;
        std::function<WayAhead(const EntityMotion&)> wayOf;
    };

    /// `source` may be null: then controllers of that kind leave the entity to the scenario.
    ExternalControl(Place place, std::shared_ptr<MotionSource> source);

    /// Lets something move an entity for the whole play, from beginAll() on.
    void attach(std::size_t entity, std::shared_ptr<ExternalMotion> motion);

    /// Gives domains of an entity to a controller, or takes them back; before beginAll() from then on.
    void wish(std::size_t entity, const Controller& controller, const Wish& wish, double timeS);

    /// Gives the entity back to the scenario, which goes on at its speed. Does nothing where nothing has it.
    void release(std::size_t entity, double timeS);

    /// Begins anew where the entity now is: after a teleport.
    void restart(std::size_t entity, double timeS);

    /// After Init. Errors: one cannot begin.
    foundation::Outcome beginAll();

    /// Moves all on to a time. `traffic`: as an entity sees the others, all as they were before.
    /// `askedPlace`: where a lateral action of the scenario wants an entity; nothing: none runs.
    void advanceTo(double timeS, const std::function<Traffic(std::size_t)>& traffic,
                   const std::function<std::optional<glm::dvec3>(std::size_t)>& askedPlace);

    bool has(std::size_t entity) const { return _external[entity].motion != nullptr; }
    bool holds(std::size_t entity, ActionDomain domain) const;
    void askForSpeed(std::size_t entity, double speedMps) { _external[entity].motion->askForSpeed(speedMps); }

    /// Whether some are attached for the whole play, and all of them are done.
    bool areDone() const;

    /// What a person should know: controllers that could not begin, crashes. A line each.
    std::vector<std::string> notes() const;

private:
    struct Attachment
    {
        std::shared_ptr<ExternalMotion> motion; ///< null: the entity moves by its actions
        std::optional<Controller> controller;   ///< absent: attached for the whole play
        bool isLongitudinal = true, isLateral = true;
    };

    foundation::Outcome begin(std::size_t entity, Attachment attachment, double timeS);

    Place _place;
    std::shared_ptr<MotionSource> _source;
    std::vector<Attachment> _external, _waiting; ///< of each entity; the latter until beginAll()
    bool _hasBegun = false;
    std::vector<std::string> _notes;
};

} // namespace simulation
