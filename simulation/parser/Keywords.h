// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "simulation/scenario/Action.h"
#include "simulation/scenario/Condition.h"
#include "simulation/scenario/Storyboard.h"

namespace simulation
{

/// The words of OpenSCENARIO for the values of an enumeration. A value is written with the first of its
/// words.
template<class Value, std::size_t Count>
using Keywords = std::array<std::pair<std::string_view, Value>, Count>;

inline constexpr Keywords<Rule, 6> kRules = {{{"equalTo", Rule::equalTo},
                                              {"greaterThan", Rule::greaterThan},
                                              {"lessThan", Rule::lessThan},
                                              {"greaterOrEqual", Rule::greaterOrEqual},
                                              {"lessOrEqual", Rule::lessOrEqual},
                                              {"notEqualTo", Rule::notEqualTo}}};

inline constexpr Keywords<ConditionEdge, 4> kConditionEdges = {
    {{"none", ConditionEdge::none},
     {"rising", ConditionEdge::rising},
     {"falling", ConditionEdge::falling},
     {"risingOrFalling", ConditionEdge::risingOrFalling}}};

inline constexpr Keywords<StoryboardElementType, 6> kElementTypes = {
    {{"story", StoryboardElementType::story},
     {"act", StoryboardElementType::act},
     {"maneuverGroup", StoryboardElementType::maneuverGroup},
     {"maneuver", StoryboardElementType::maneuver},
     {"event", StoryboardElementType::event},
     {"action", StoryboardElementType::action}}};

inline constexpr Keywords<StoryboardElementState, 7> kElementStates = {
    {{"standbyState", StoryboardElementState::standbyState},
     {"runningState", StoryboardElementState::runningState},
     {"completeState", StoryboardElementState::completeState},
     {"startTransition", StoryboardElementState::startTransition},
     {"endTransition", StoryboardElementState::endTransition},
     {"stopTransition", StoryboardElementState::stopTransition},
     {"skipTransition", StoryboardElementState::skipTransition}}};

inline constexpr Keywords<DynamicsShape, 4> kDynamicsShapes = {{{"step", DynamicsShape::step},
                                                                {"linear", DynamicsShape::linear},
                                                                {"cubic", DynamicsShape::cubic},
                                                                {"sinusoidal", DynamicsShape::sinusoidal}}};

inline constexpr Keywords<DynamicsDimension, 3> kDynamicsDimensions = {
    {{"time", DynamicsDimension::time},
     {"distance", DynamicsDimension::distance},
     {"rate", DynamicsDimension::rate}}};

inline constexpr Keywords<DistanceFrame, 5> kDistanceFrames = {{{"entity", DistanceFrame::entity},
                                                                {"road", DistanceFrame::road},
                                                                {"lane", DistanceFrame::lane},
                                                                {"trajectory", DistanceFrame::trajectory},
                                                                {"world", DistanceFrame::world}}};

inline constexpr Keywords<DistanceKind, 4> kDistanceKinds = {{{"euclidianDistance", DistanceKind::euclidean},
                                                              {"cartesianDistance", DistanceKind::euclidean},
                                                              {"longitudinal", DistanceKind::longitudinal},
                                                              {"lateral", DistanceKind::lateral}}};

inline constexpr Keywords<Direction, 3> kDirections = {{{"longitudinal", Direction::longitudinal},
                                                        {"lateral", Direction::lateral},
                                                        {"vertical", Direction::vertical}}};

inline constexpr Keywords<AngleCondition::Kind, 3> kAngleTypes = {{{"heading", AngleCondition::Kind::heading},
                                                                   {"pitch", AngleCondition::Kind::pitch},
                                                                   {"roll", AngleCondition::Kind::roll}}};

inline constexpr Keywords<bool, 2> kSpeedValueTypes = {{{"delta", false}, {"factor", true}}};

inline constexpr Keywords<bool, 2> kTriggeringRules = {{{"any", false}, {"all", true}}};

/// The side of the other entity on which a distance is kept.
inline constexpr Keywords<int, 3> kDisplacements = {
    {{"any", 0}, {"trailingReferencedEntity", 1}, {"leadingReferencedEntity", -1}}};

inline constexpr Keywords<int, 3> kLateralDisplacements = {
    {{"any", 0}, {"leftToReferencedEntity", 1}, {"rightToReferencedEntity", -1}}};

inline constexpr Keywords<LightMode, 3> kLightModes = {
    {{"off", LightMode::off}, {"on", LightMode::on}, {"flashing", LightMode::flashing}}};

inline constexpr Keywords<GearLever, 4> kGearLevers = {{{"d", GearLever::forward},
                                                        {"r", GearLever::reverse},
                                                        {"n", GearLever::neutral},
                                                        {"p", GearLever::park}}};

inline constexpr Keywords<RouteStrategy, 4> kRouteStrategies = {
    {{"shortest", RouteStrategy::shortest},
     {"fastest", RouteStrategy::fastest},
     {"leastIntersections", RouteStrategy::leastIntersections},
     {"random", RouteStrategy::random}}};

inline constexpr Keywords<FollowingMode, 2> kFollowingModes = {
    {{"position", FollowingMode::position}, {"follow", FollowingMode::follow}}};

inline constexpr Keywords<Timing::Domain, 2> kTimingDomains = {
    {{"absolute", Timing::Domain::absolute}, {"relative", Timing::Domain::relative}}};

/// OpenSCENARIO 1.2 writes `override` for `overwrite`; both words are read in all versions.
inline constexpr Keywords<Priority, 4> kPriorities = {{{"overwrite", Priority::overwrite},
                                                       {"override", Priority::overwrite},
                                                       {"skip", Priority::skip},
                                                       {"parallel", Priority::parallel}}};

/// Returns the first word for a value.
template<class Value, std::size_t Count>
constexpr std::string_view wordFor(const Keywords<Value, Count>& keywords, Value value)
{
    for (const auto& [word, candidate] : keywords)
        if (candidate == value) return word;
    return {};
}

} // namespace simulation
