#version 440

// A plain area; hatch.frag draws a hatched one.
layout(location = 0) in vec2 pixel;
layout(location = 0) out vec4 fragColor;

layout(std140, binding = 0) uniform buf {
    mat4 matrix;
    vec4 color;
    vec4 hatch;
};

void main() {
    fragColor = color;
}
