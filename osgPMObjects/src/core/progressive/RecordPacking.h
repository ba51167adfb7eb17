// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

namespace osgPMObjects::core
{

/// Returns the records of some steps (StepRecord) in the form that they have in files, which takes fewer
/// bytes and is read once, in order:
/// - without their lengths;
/// - cycles begin with 0 and twice their block, one more for a table. A table has the extents before and
///   after, and for each slot after the change where its face comes from, as a difference to the slot
///     behind
///   the source before. Cycles follow as they are where they take fewer bytes than their table.
/// `progressive`: its widths of numbers; `records`: whole records, the finest step first, all valid.
std::string packedRecords(const ProgressiveMesh& progressive, std::span<const std::byte> records);

/// Returns the records of `steps` steps as they were before packedRecords(): bit for bit, if their cycles are
/// those of SlotCycles. Whatever the bytes are, they are read within their end, and memory is limited by
/// their number and that of the slots; isValid() tells whether steps make sense. Returns nothing where the
/// bytes are not just as many records.
std::optional<std::string> unpackedRecords(const ProgressiveMesh& progressive, std::string_view packed,
                                           std::uint32_t steps);

} // namespace osgPMObjects::core
