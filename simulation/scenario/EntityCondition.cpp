// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/EntityCondition.h"

namespace simulation
{

EntityConditionContent::EntityConditionContent() = default;
EntityConditionContent::EntityConditionContent(const EntityConditionContent&) = default;
EntityConditionContent::EntityConditionContent(EntityConditionContent&&) noexcept = default;
EntityConditionContent& EntityConditionContent::operator=(const EntityConditionContent&) = default;
EntityConditionContent& EntityConditionContent::operator=(EntityConditionContent&&) noexcept = default;
EntityConditionContent::~EntityConditionContent() = default;
bool EntityConditionContent::operator==(const EntityConditionContent&) const = default;

} // namespace simulation
