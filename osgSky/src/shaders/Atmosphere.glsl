// SPDX-License-Identifier: Apache-2.0
// Defines the light of sun and sky, the haze, and the step from linear to display values. The class Atmosphere lists the
// functions and sets the uniforms. The sky's colours and the glow were chosen by eye. GLSL 1.30.

uniform vec3 atmosphereSunDirection;
uniform vec3 atmosphereSun;
uniform vec3 atmosphereSky;
uniform vec3 atmosphereGround;
uniform vec3 atmosphereZenith;
uniform vec3 atmosphereHorizon;
uniform vec3 atmosphereGlow;
uniform vec3 atmosphereExtinction;
uniform float atmosphereExposure;
uniform vec2 atmosphereLayer; // height of the haze's base in the world, 1 / scale height
uniform mat4 osg_ViewMatrixInverse;
#pragma import_defines(SURFACE_WEATHER)
#ifdef SURFACE_WEATHER
uniform vec4 surfaceWeather;  // how wet sealed ground looks, 0 ... 1; snow, cm; 1: the water is ice; 1: roads have no snow
uniform vec2 surfaceSnowLine; // height in the world from which all of the snow lies; 1 / metres below it over which it ends
#endif

vec3 sunDirection() { return atmosphereSunDirection; }
vec3 sunLight() { return atmosphereSun; }

vec3 skyColour(vec3 directionWorld)
{
    // A direction below the horizon is flattened: the colour stays continuous, and haze over the ground keeps its glow.
    vec3 direction = vec3(directionWorld.xy, max(directionWorld.z, 0.0));
    float low = 1.0 - direction.z;
    float low2 = low * low;
    float horizonShare = low2 * low2 * low;
    float toSun = max(dot(direction, atmosphereSunDirection), 0.0);
    float s2 = toSun * toSun;
    float s4 = s2 * s2;
    float s16 = s4 * s4 * s4 * s4;
    float s64 = s16 * s16 * s16 * s16;
    float glow = s4 * (0.10 + 0.25 * horizonShare) + 0.22 * s16 + 0.45 * s64 * s64;
    return mix(atmosphereZenith, atmosphereHorizon, horizonShare) + glow * atmosphereGlow;
}

vec3 sunDisc(vec3 directionWorld)
{
    // The disc is 0.53 degrees wide; its edge is soft, so that it does not flicker as it moves.
    float edge = smoothstep(0.999960, 0.999990, dot(directionWorld, atmosphereSunDirection));
    return edge * 12.0 * atmosphereGlow;
}

vec3 applyHaze(vec3 colour, vec3 directionWorld, float distanceM)
{
    // The density of the haze falls exponentially with height, so its integral along the ray has a closed form.
    float rise = clamp(directionWorld.z * distanceM * atmosphereLayer.y, -20.0, 20.0);
    float mean = abs(rise) < 0.01 ? 1.0 - 0.5 * rise : (1.0 - exp(-rise)) / rise;
    float eye = exp(-max(osg_ViewMatrixInverse[3].z - atmosphereLayer.x, 0.0) * atmosphereLayer.y);
    vec3 transmittance = exp(-atmosphereExtinction * (distanceM * mean * eye));
    return mix(skyColour(directionWorld), colour, transmittance);
}

vec3 ambientLight(vec3 normalWorld)
{
#ifdef SURFACE_WEATHER
    // Snow throws back six times what grass and soil do.
    return mix(atmosphereGround * (1.0 + 5.0 * tanh(0.2 * surfaceWeather.y)), atmosphereSky, 0.5 + 0.5 * normalWorld.z);
#else
    return mix(atmosphereGround, atmosphereSky, 0.5 + 0.5 * normalWorld.z);
#endif
}

vec3 lightOn(vec3 normalWorld, float sunlit, float skyShare)
{
    return sunLight() * sunlit + ambientLight(normalWorld) * skyShare;
}

vec3 displayColour(vec3 linear)
{
    // ToneMapping.cpp has it again, and its sources. The eighth root lifts the contrast to the power of 1.125.
    vec3 exposed = max(atmosphereExposure * linear, 0.0);
    return sqrt(1.0 - exp(-exposed * sqrt(sqrt(sqrt(exposed)))));
}
