// SPDX-License-Identifier: Apache-2.0
// Where OpenAL is not at hand when this is built.
#include "sound/Loudspeaker.h"

namespace trainer
{

Loudspeaker::Loudspeaker() : _fault("this build has no OpenAL") {}
Loudspeaker::~Loudspeaker() = default;

void Loudspeaker::set(const simulation::SoundState& /*state*/) {}
void Loudspeaker::pause() {}

} // namespace trainer
