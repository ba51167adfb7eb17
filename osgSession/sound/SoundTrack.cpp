// SPDX-License-Identifier: Apache-2.0
#include "sound/SoundTrack.h"

namespace trainer
{

SoundTrack::SoundTrack(const SoundRequest& request, const simulation::Scenario& scenario,
                       std::size_t listener, int picturesPerSecond)
    : _scene(scenario, listener),
      _file(request.file, simulation::Synthesiser::kRate),
      _isMuted(request.isMuted),
      _perSecond(picturesPerSecond)
{
}

foundation::Outcome SoundTrack::add(const std::vector<simulation::EntityState>& entities,
                                    const simulation::ExternalMotion* motion)
{
    const auto samplesTo = [&](long picture)
    { return picture * simulation::Synthesiser::kRate / _perSecond; };
    const long count = samplesTo(_pictures + 1) - samplesTo(_pictures);
    ++_pictures;
    std::vector<float> samples(2 * static_cast<std::size_t>(count), 0.0F);
    const simulation::SoundState state = _scene.hear(entities, vehicleOf(motion));
    if (!_isMuted) _synthesiser.render(state, samples);
    return _file.add(samples);
}

} // namespace trainer
