// -*- c++ -*-
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include <foundation/Result.h>

#include <osgPMObjects/ReadModel>

namespace osgPMObjects
{

/// Does `work` in a child process and returns the bytes it made, or its error. `what` names the work in the error that says how the
/// child died: by a signal, by taking too long, by wanting too much memory. What the child prints is not shown.
foundation::Result<std::string> runContained(const std::function<foundation::Result<std::string>()>& work,
                                             const std::string& file, const std::string& what,
                                             const ReadLimits& limits);

} // namespace osgPMObjects
