// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/Condition.h"

namespace simulation
{

ConditionContent::ConditionContent() = default;
ConditionContent::ConditionContent(const ConditionContent&) = default;
ConditionContent::ConditionContent(ConditionContent&&) noexcept = default;
ConditionContent& ConditionContent::operator=(const ConditionContent&) = default;
ConditionContent& ConditionContent::operator=(ConditionContent&&) noexcept = default;
ConditionContent::~ConditionContent() = default;
bool ConditionContent::operator==(const ConditionContent&) const = default;

} // namespace simulation
