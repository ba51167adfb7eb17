// SPDX-License-Identifier: Apache-2.0
// Lights the inside of a vehicle: the shares of sun and sky that come in, and the light of its own lamps. No haze: it is near.

in vec3 normalWorld;
in vec4 colour;
in vec2 textureAt;
uniform sampler2D objectTexture;
uniform float objectTintMask;
uniform vec2 interiorShare; // of the sun and of the sky
uniform vec3 interiorLamp;
void main()
{
    float shownAlpha = pmAlpha();
    vec3 normal = normalize(normalWorld);
    if (!gl_FrontFacing) normal = -normal;
    vec4 texel = texture(objectTexture, textureAt, -0.75); // scales stay legible where there is no anisotropic filter
    vec4 paint = colour * texel;
    if (objectTintMask > 0.0) paint = vec4(mix(texel.rgb, paint.rgb, texel.a), 1.0);
    vec3 albedo = paint.rgb * paint.rgb; // the inverse of displayColour's gamma
    vec3 light = lightOn(normal, interiorShare.x * max(dot(normal, sunDirection()), 0.0), interiorShare.y) + interiorLamp;
    gl_FragColor = vec4(displayColour(albedo * light), shownAlpha);
}
