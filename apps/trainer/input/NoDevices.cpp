// SPDX-License-Identifier: Apache-2.0
// Where SDL is not at hand when this is built.
#include "input/Devices.h"

namespace trainer
{

Devices::Devices() : _fault("this build has no SDL2") {}
Devices::~Devices() = default;

std::vector<std::string> Devices::update()
{
    return {};
}

} // namespace trainer
