// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/Position.h"

#include "simulation/scenario/Trajectory.h"

namespace simulation
{

Position::Position() = default;
Position::Position(const Position&) = default;
Position::Position(Position&&) noexcept = default;
Position& Position::operator=(const Position&) = default;
Position& Position::operator=(Position&&) noexcept = default;
Position::~Position() = default;
bool Position::operator==(const Position&) const = default;

} // namespace simulation
