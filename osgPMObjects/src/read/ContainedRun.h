// -*- c++ -*-
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include <foundation/Result.h>

#include <osgPMObjects/ReadModel>

namespace osgPMObjects
{

/// Does `work` in a child process and returns its bytes or its error. `what` names the work in the error that
/// tells how the child ended: by a signal, by its time limit, by its memory limit. Output of the child is not
/// shown.
foundation::Result<std::string> runContained(const std::function<foundation::Result<std::string>()>& work,
                                             const std::string& file, const std::string& what,
                                             const ReadLimits& limits);

} // namespace osgPMObjects
