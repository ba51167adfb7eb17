// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace simulation
{

/// The cells of one row that may tell which object it is of, in the order of TableColumns::ids.
using RowIds = std::vector<std::string>;

/// Which of those cells parts the rows by objects; nothing: all rows are of one. The surest one counts in
/// which two rows or more belong to an object on average; an address that stays the same means one object,
/// whatever its flights are called. A number of its own in each row is none.
std::optional<std::size_t> partingId(const std::vector<RowIds>& rows);

} // namespace simulation
