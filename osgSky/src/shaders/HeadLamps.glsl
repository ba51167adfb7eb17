// SPDX-License-Identifier: Apache-2.0
// The light that the head lamps of one vehicle throw on what is before it. Follows Atmosphere.glsl. GLSL 1.30.
// HEAD_LAMPS: they are lit; the uniforms are those of scenery::HeadLampBeam. Without it programs have no such light.
//   vec3 headLight(vec3 fromEyeWorld, vec3 normalWorld)   irradiance of a surface
// The beam is dipped: it ends at the horizon of the vehicle and is strongest just below, so that the road is lit evenly. Nothing casts
// shadows in it. The shape was chosen by eye.

#pragma import_defines(HEAD_LAMPS)

uniform float atmosphereLampShare; // what an eye that is used to the light about sees of lamps

#ifdef HEAD_LAMPS
uniform vec3 headLampAt;   // in the world, between the lamps
uniform mat3 headLampAxes; // from world axes to ahead, left, up of the vehicle
#endif

vec3 headLight(vec3 fromEyeWorld, vec3 normalWorld)
{
#ifdef HEAD_LAMPS
    vec3 fromLamp = fromEyeWorld + (osg_ViewMatrixInverse[3].xyz - headLampAt);
    vec3 at = headLampAxes * fromLamp;
    if (at.x < 0.3) return vec3(0.0);
    float distanceM = length(fromLamp);
    // The eye gets used to bright walls: what faces the lamps and what is near count for less than they would on a light meter.
    float facing = sqrt(max(-dot(normalWorld, fromLamp), 0.0) / distanceM);
    float across = at.y / at.x;
    float below = -at.z / at.x;
    float spread = exp(-6.0 * across * across);
    // A little stray light above the edge shows signs and trunks.
    float beam = mix(1.0, 1.0 / (max(below, 0.0) + 0.03), smoothstep(-0.004, 0.012, below));
    // Little goes down steeply: the road right before the car is no brighter than that a few lengths ahead.
    beam /= 1.0 + 100.0 * below * below;
    return vec3(1.0, 0.94, 0.82) * (28.0 * atmosphereLampShare * spread * beam * facing / (distanceM * sqrt(distanceM)));
#else
    return vec3(0.0);
#endif
}
