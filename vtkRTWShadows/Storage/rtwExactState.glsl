// What is known of a pixel: a bit for each of its samples that is in shadow, and whether it faces the light.
const uint STATE_FACES = 1u << 8;
const uint OWNER_PIXEL_BITS = 28u;
const uint OWNER_PIXELS = (1u << OWNER_PIXEL_BITS) - 1u;
