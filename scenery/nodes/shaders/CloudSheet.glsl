// SPDX-License-Identifier: Apache-2.0
// Lays the picture of the clouds over the scene. AMONG: at their distance, so that what is nearer hides them.

in vec3 direction;
in vec2 place;
uniform sampler2D cloudColour;
uniform sampler2D cloudAway;
uniform mat4 osg_ViewMatrixInverse;
void main()
{
    vec4 cloud = texture(cloudColour, place);
    if (cloud.a < 0.004) discard;
    gl_FragColor = cloud;
#ifdef AMONG
    // The part of the way that goes straight ahead is what the depth counts.
    // The nearest of the four texels that the colour is mixed of: an empty one beside a cloud is far off.
    vec2 texel = 0.5 / vec2(textureSize(cloudAway, 0));
    float away = min(min(texture(cloudAway, place - texel).r, texture(cloudAway, place + texel).r),
                     min(texture(cloudAway, place + vec2(texel.x, -texel.y)).r, texture(cloudAway, place + vec2(-texel.x, texel.y)).r));
    float cosine = dot(normalize(direction), -osg_ViewMatrixInverse[2].xyz);
    vec4 ahead = gl_ProjectionMatrix * vec4(0.0, 0.0, -away * cosine, 1.0);
    gl_FragDepth = clamp(0.5 + 0.5 * ahead.z / ahead.w, 0.0, 1.0);
#endif
}
