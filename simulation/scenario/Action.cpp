// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/Action.h"

namespace simulation
{

PrivateAction::PrivateAction() = default;
PrivateAction::PrivateAction(const PrivateAction&) = default;
PrivateAction::PrivateAction(PrivateAction&&) noexcept = default;
PrivateAction& PrivateAction::operator=(const PrivateAction&) = default;
PrivateAction& PrivateAction::operator=(PrivateAction&&) noexcept = default;
PrivateAction::~PrivateAction() = default;
bool PrivateAction::operator==(const PrivateAction&) const = default;

GlobalAction::GlobalAction() = default;
GlobalAction::GlobalAction(const GlobalAction&) = default;
GlobalAction::GlobalAction(GlobalAction&&) noexcept = default;
GlobalAction& GlobalAction::operator=(const GlobalAction&) = default;
GlobalAction& GlobalAction::operator=(GlobalAction&&) noexcept = default;
GlobalAction::~GlobalAction() = default;
bool GlobalAction::operator==(const GlobalAction&) const = default;

} // namespace simulation
