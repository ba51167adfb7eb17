// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace worldtool
{

/// Lets this process run on `most` of its processors; 0: on all of them. What is made in parallel then has as
/// many threads: they ask how many there are. The result does not depend on it. Call it before the first
/// thread is begun.
void limitProcessors(int most);

} // namespace worldtool
