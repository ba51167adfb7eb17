// SPDX-License-Identifier: Apache-2.0
// Blends imagery of several resolutions: vec4 layeredImagery(vec2 grid) returns colour and coverage. A finer layer lies over
// a coarser one and fades towards its border, over a fiftieth of its extent. RepeatedLayers.cpp replaces the lines <...>.

// <uniforms>

// Mixes colours weighted by their shares: unweighted, a border would be dark.
void addLayer(inout vec4 below, sampler2D layer, vec2 at)
{
    vec4 here = texture(layer, at); // unconditional: the mip level depends on neighbouring pixels
    vec2 inward = smoothstep(vec2(0.0), vec2(0.02), 0.5 - abs(at - 0.5));
    float share = here.a * inward.x * inward.y;
    float all = share + below.a * (1.0 - share);
    below = vec4(mix(below.rgb, here.rgb, share / max(all, 1e-4)), all);
}

vec4 layeredImagery(vec2 grid)
{
    vec4 imagery = vec4(0.0);
    // <layers>
    return imagery;
}
