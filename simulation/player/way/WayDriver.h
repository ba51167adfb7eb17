// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "simulation/player/actions/RunningAction.h"
#include "simulation/player/way/DrivenWay.h"
#include "simulation/player/way/JunctionKeeper.h"
#include "simulation/player/way/LeadOnWay.h"

namespace simulation
{

/// What somebody who keeps the rules has to know for its speed.
struct WayAdvice
{
    double allowedMps = 0.0; ///< by limits and bends, here and ahead
    std::optional<LeadOnWay> lead;
    std::optional<double> lineM;  ///< from the front to where it has to stop before a junction
    std::optional<double> lightM; ///< to where it has to stop before a traffic light
    std::optional<double> signM;  ///< to the next stop sign
};

/// The eyes of a driver who keeps the rules: it knows its way, sees who is on it, heeds lights, and asks at
/// junctions.
/// Nobody is let in who could not leave the junction again.
class WayDriver
{
public:
    /// `keeper`: of the scene. `givesWay`: else it drives into junctions without asking.
    WayDriver(ActionScene& scene, std::shared_ptr<JunctionKeeper> keeper, int actor, bool givesWay);
    ~WayDriver();
    WayDriver(const WayDriver&) = delete;
    WayDriver& operator=(const WayDriver&) = delete;

    /// Nothing: the vehicle is on no road.
    std::optional<WayAdvice> look(ActionScene& scene, double speedMps);

private:
    /// The light at whose line it is, while that is amber.
    struct Amber
    {
        double lineM = 0.0, sinceS = 0.0;
        bool hasWaited = false; ///< there, on green
    };

    void measure(ActionScene& scene, double speedMps);
    void lookAtLines(const ActionScene& scene, WayAdvice& advice);
    bool goesOnAmber(const ActionScene& scene, const DrivenWay::Line& line, const std::string& state);
    void markLights(const ActionScene& scene, std::optional<double> redAtM);
    void giveBack();
    std::optional<double> ask(ActionScene& scene);
    double lookM() const;
    std::size_t firstNotHeld() const;
    bool isChained(std::size_t claim) const;
    std::size_t chainFrom(std::size_t first) const;
    std::optional<int> whoTakesRoom(std::size_t first, std::size_t end) const;
    bool isStrangerAhead(ActionScene& scene, std::size_t first, std::size_t end) const;
    double endOf(std::size_t claim) const;

    std::shared_ptr<JunctionKeeper> _keeper;
    int _actor;
    bool _givesWay;
    DrivenWay _way;
    JunctionApproach* _own = nullptr; ///< as others know it; valid for a look
    double _frontM = 0.0;             ///< along the way
    std::vector<LeadOnWay> _ahead;    ///< who is on it, the nearest first
    bool _isInKnot = false;           ///< as JunctionKeeper::isInKnot()
    std::optional<Amber> _amber;
};

} // namespace simulation
