// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/XmlSource.h>

namespace simulation
{

using foundation::XmlSource;

} // namespace simulation
