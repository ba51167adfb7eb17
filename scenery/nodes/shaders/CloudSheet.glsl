// SPDX-License-Identifier: Apache-2.0
// Lays the picture of the clouds over the scene. AMONG: at their distance, so that what is nearer hides them.
// A texel of that picture is some pixels wide. The colour is a cubic B-spline over 4 x 4 texels: no edge shows their squares, and the pattern by which
// neighbouring rays differ is averaged away.
// Source: Sigg and Hadwiger, Fast third-order texture filtering, GPU Gems 2 (2005), chapter 20: the spline by four bilinear samples.

in vec3 direction;
in vec2 place;
uniform sampler2D cloudColour;
uniform sampler2D cloudAway;
uniform mat4 osg_ViewMatrixInverse;

vec4 smoothColour(vec2 size)
{
    vec2 at = place * size - 0.5;
    vec2 f = fract(at), f2 = f * f, f3 = f2 * f;
    vec2 first = (1.0 + 3.0 * (f2 - f) - f3) / 6.0; // weights of the four texels along an axis
    vec2 second = (4.0 - 6.0 * f2 + 3.0 * f3) / 6.0;
    vec2 fourth = f3 / 6.0;
    vec2 low = first + second, high = 1.0 - low;
    vec2 whole = (floor(at) + 0.5) / size;
    vec2 a = whole + (second / low - 1.0) / size, b = whole + (1.0 + fourth / high) / size;
    return (texture(cloudColour, a) * low.x + texture(cloudColour, vec2(b.x, a.y)) * high.x) * low.y +
           (texture(cloudColour, vec2(a.x, b.y)) * low.x + texture(cloudColour, b) * high.x) * high.y;
}

#ifdef AMONG
// The distance between the four texels around, each as much as there is of cloud: what is empty has none.
float smoothAway(vec2 size)
{
    vec2 at = place * size - 0.5;
    vec2 f = fract(at);
    ivec2 whole = ivec2(floor(at)), last = ivec2(size) - 1;
    float sum = 0.0, weights = 0.0;
    for (int i = 0; i < 4; ++i)
    {
        ivec2 corner = ivec2(i & 1, i >> 1), texel = clamp(whole + corner, ivec2(0), last);
        float weight = (corner.x == 1 ? f.x : 1.0 - f.x) * (corner.y == 1 ? f.y : 1.0 - f.y) * texelFetch(cloudColour, texel, 0).a + 1e-6;
        sum += weight * texelFetch(cloudAway, texel, 0).r;
        weights += weight;
    }
    return sum / weights;
}
#endif

void main()
{
    vec2 size = vec2(textureSize(cloudColour, 0));
    vec4 cloud = smoothColour(size);
    if (cloud.a < 0.004) discard;
    gl_FragColor = cloud;
#ifdef AMONG
    // The part of the way that goes straight ahead is what the depth counts.
    float cosine = dot(normalize(direction), -osg_ViewMatrixInverse[2].xyz);
    vec4 ahead = gl_ProjectionMatrix * vec4(0.0, 0.0, -smoothAway(size) * cosine, 1.0);
    gl_FragDepth = clamp(0.5 + 0.5 * ahead.z / ahead.w, 0.0, 1.0);
#endif
}
