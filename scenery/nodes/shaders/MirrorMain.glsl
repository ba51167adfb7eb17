// SPDX-License-Identifier: Apache-2.0
// Shows the picture of a mirror a little darker than what it mirrors.

in vec2 textureAt;
uniform sampler2D objectTexture;
void main()
{
    gl_FragColor = vec4(0.88 * texture(objectTexture, textureAt).rgb, pmAlpha());
}
